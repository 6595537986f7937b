"""Nodes that query the graph."""
