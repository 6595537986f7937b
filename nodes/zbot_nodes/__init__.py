"""Nodes that come with zbot; each is one short file."""
