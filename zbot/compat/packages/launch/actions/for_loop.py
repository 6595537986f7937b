"""Loops under the name of their own module."""

from zbot.launch.actions import ForEach, ForLoop
