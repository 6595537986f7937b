"""Loops under their own module's name."""

from zbot.launch.actions import ForEach as ForEach
from zbot.launch.actions import ForLoop as ForLoop
