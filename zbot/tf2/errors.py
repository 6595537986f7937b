"""Errors of transforms, with the names of ROS 2's tf2."""

from __future__ import annotations

from zbot.errors import ZbotError, described


def kind_of(value: object) -> str:
    """Return what an argument is, without its value, e.g. `PoseStamped` or `the class Pose`."""
    return described(value).partition(":")[0]


class TransformException(ZbotError):  # noqa: N818 - all names here are tf2's
    """Base of all errors about transforms."""


class LookupException(TransformException):
    """A frame does not exist."""


class ConnectivityException(TransformException):
    """Two frames exist, but in different trees."""


class ExtrapolationException(TransformException):
    """The requested time is before or after all known samples."""


class InvalidArgumentException(TransformException):
    """A name is not valid as a frame's name."""


class TimeoutException(TransformException):
    """The transform did not become known in time."""


class TypeException(TransformException):
    """No function is registered that transforms objects of a class."""


class NotImplementedException(TransformException):
    """A subclass does not implement a method."""
