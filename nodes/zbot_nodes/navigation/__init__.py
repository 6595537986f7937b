"""Nodes of nav2 that are not about driving: maps, and the states of managed nodes."""
