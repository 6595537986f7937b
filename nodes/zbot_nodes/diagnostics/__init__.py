"""Nodes that summarize diagnostics."""
