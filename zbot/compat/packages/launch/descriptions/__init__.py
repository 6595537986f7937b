"""Descriptions of programs to execute."""

from zbot.launch.actions.executable import Executable
