"""What can be wrong with a transform. The names are those of ROS 2's tf2."""

from __future__ import annotations

from zbot.errors import ZbotError


class TransformException(ZbotError):  # noqa: N818 - tf2's name, as all here
    """A transform cannot be had; the base of all others."""


class LookupException(TransformException):
    """A frame does not exist."""


class ConnectivityException(TransformException):
    """Two frames exist, and nothing connects them."""


class ExtrapolationException(TransformException):
    """The time asked for lies before or behind everything that is known."""


class InvalidArgumentException(TransformException):
    """A frame's name cannot be one."""


class TimeoutException(TransformException):
    """The transform did not come in time."""


class TypeException(TransformException):
    """Nobody knows how to transform objects of a class."""


class NotImplementedException(TransformException):
    """A method that a subclass has to write."""
