"""Nodes of Nav2 and of slam_toolbox: maps, poses, paths, driving, and states of nodes."""
