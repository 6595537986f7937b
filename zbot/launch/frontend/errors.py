"""What can be wrong with launch files in XML and YAML."""

from __future__ import annotations

from zbot.launch.errors import LaunchFileError


class InvalidFrontendLaunchFileError(LaunchFileError):
    """A launch file in XML or YAML makes no sense."""


class SubstitutionSyntaxError(ValueError):
    """A text with `$(...)` breaks the grammar."""
