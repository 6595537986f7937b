"""Nodes for a look at the graph."""
