"""Sensors: what a robot measures in a world."""
