"""Nodes that read a robot description: its frames, its joints, its sliders."""
