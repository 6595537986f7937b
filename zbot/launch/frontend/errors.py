"""Errors in launch files in XML and YAML."""

from __future__ import annotations

from zbot.launch.errors import LaunchFileError


class InvalidFrontendLaunchFileError(LaunchFileError, ValueError):
    """A launch file in XML or YAML is invalid."""


class MissingAttributeError(InvalidFrontendLaunchFileError, AttributeError):
    """A required attribute or child is missing."""


class AttributeTypeError(InvalidFrontendLaunchFileError, TypeError):
    """An attribute has the wrong type."""


class SubstitutionSyntaxError(ValueError):
    """A text with `$(...)` does not follow the grammar."""
