"""Nodes that come with zbot. Each node is one short file."""
