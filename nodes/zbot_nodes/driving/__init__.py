"""Nodes that turn a gamepad into velocities, and choose between sources of velocities."""
