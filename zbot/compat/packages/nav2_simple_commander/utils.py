"""Rotations. The functions that kill processes by name are left out."""

from zbot.libraries.navigation.costmap import euler_to_quaternion
