"""Arrangement of a view: its displays, its fixed frame and its camera, as in an `.rviz` file."""
