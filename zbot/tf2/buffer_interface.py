"""Interface of buffers, with methods that transform objects of registered classes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.errors import ArgumentTypeError
from zbot.tf2 import conversion
from zbot.tf2.errors import NotImplementedException, TypeException
from zbot.time import Duration, Time

if TYPE_CHECKING:
    from collections.abc import Callable

NO_WAIT = Duration()
_conversions: dict[tuple[type[Any], type[Any]], Callable[[Any], Any]] = {}


def check_timeout(timeout: object) -> None:
    """Check that a timeout is a `Duration`.

    Raises:
        ArgumentTypeError: It is something else, e.g. a number of seconds.
    """
    if not isinstance(timeout, Duration):
        example = (
            f", e.g. Duration(seconds={timeout!r})" if isinstance(timeout, (int, float)) else ""
        )
        raise ArgumentTypeError("timeout", f"a Duration{example}", timeout)


class BufferInterface:
    """Base class of buffers. A subclass implements the lookups."""

    def lookup_transform(
        self, target_frame: str, source_frame: str, time: Any, timeout: Duration = NO_WAIT
    ) -> Any:
        """Return the transform of `source_frame` in `target_frame`, as `TransformStamped`."""
        raise NotImplementedException(f"{type(self).__name__} has no lookup_transform")

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
    ) -> Any:
        """Return the transform of `source_frame` in `target_frame`, with a time for each frame."""
        raise NotImplementedException(f"{type(self).__name__} has no lookup_transform_full")

    def transform(
        self,
        object_stamped: Any,
        target_frame: str,
        timeout: Duration = NO_WAIT,
        new_type: type[Any] | None = None,
    ) -> Any:
        """Return a stamped point, vector or pose in another frame.

        Args:
            object_stamped: An object of a registered class.
            target_frame: The frame of the result.
            timeout: Longest time to wait until the transform is known.
            new_type: The class to convert the result to.

        Raises:
            TypeException: No function is registered to transform or convert the object's class.
            TransformException: The transform is not known, as in `Buffer.lookup_transform`.
        """
        do_transform = conversion.registered(type(object_stamped))
        header = object_stamped.header
        when = Time.from_msg(header.stamp)
        found = self.lookup_transform(target_frame, header.frame_id, when, timeout)
        moved = do_transform(object_stamped, found)
        return moved if new_type is None else convert(moved, new_type)

    def transform_full(
        self,
        object_stamped: Any,
        target_frame: str,
        target_time: Any,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
        new_type: type[Any] | None = None,
    ) -> Any:
        """Return a stamped point, vector or pose in `target_frame` at `target_time`."""
        do_transform = conversion.registered(type(object_stamped))
        header = object_stamped.header
        when = Time.from_msg(header.stamp)
        found = self.lookup_transform_full(
            target_frame, target_time, header.frame_id, when, fixed_frame, timeout
        )
        moved = do_transform(object_stamped, found)
        return moved if new_type is None else convert(moved, new_type)


def convert(value: Any, new_type: type[Any]) -> Any:
    """Return an object converted by a function that was registered with `ConvertRegistration`.

    Raises:
        TypeException: No function is registered for these classes.
    """
    if type(value) is new_type:
        return value
    conversion_to = _conversions.get((type(value), new_type))
    if conversion_to is None:
        raise TypeException(
            f"Type {type(value).__qualname__} cannot be converted to {new_type.__qualname__}: "
            "register a function with ConvertRegistration().add_convert"
        )
    return conversion_to(value)


class TransformRegistration:
    """Registry of the functions that buffers use to transform objects."""

    def add(self, key: type[Any], callback: Callable[[Any, Any], Any]) -> None:
        """Register a function that makes a new object from an object and a `TransformStamped`."""
        conversion.add(key, callback)

    def get(self, key: type[Any]) -> Callable[[Any, Any], Any]:
        """Return the function of a class.

        Raises:
            TypeException: No function is registered for the class.
        """
        return conversion.registered(key)


class ConvertRegistration:
    """Registry of the functions that `convert` uses."""

    def add_convert(self, key: tuple[type[Any], type[Any]], callback: Callable[[Any], Any]) -> None:
        """Register a function for the pair of its argument's class and its result's class."""
        _conversions[key] = callback
