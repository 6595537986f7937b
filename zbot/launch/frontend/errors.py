"""What can be wrong with launch files in XML and YAML."""

from __future__ import annotations

from zbot.launch.errors import LaunchFileError


class InvalidFrontendLaunchFileError(LaunchFileError, ValueError):
    """A launch file in XML or YAML makes no sense."""


class MissingAttributeError(InvalidFrontendLaunchFileError, AttributeError):
    """An entity lacks an attribute, or children of a kind, that it needs."""


class AttributeTypeError(InvalidFrontendLaunchFileError, TypeError):
    """An attribute has a value of another type."""


class SubstitutionSyntaxError(ValueError):
    """A text with `$(...)` breaks the grammar."""
