"""Laptop of a student: joining and leaving a class, and the state of the laptop."""
