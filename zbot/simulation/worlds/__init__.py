"""Worlds: walls and things from plans, maps and MJCF files."""
