"""Nodes that change the form of images."""
