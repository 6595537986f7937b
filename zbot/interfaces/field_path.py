"""Paths to parts of a message, e.g. `poses[0].position`."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any, TypeAlias

from zbot.errors import ZbotError
from zbot.errors.suggestion import did_you_mean
from zbot.interfaces import spec_of

if TYPE_CHECKING:
    from collections.abc import Sequence

_INDICES = r"(?:\[[^\[\]]*\])"
_PART = re.compile(rf"(?P<name>\w+)(?P<indices>{_INDICES}*)\Z")
# ros2 separates an index with a dot: poses.[0].position
_LATER_PART = re.compile(rf"(?P<name>\w+|(?=\[))(?P<indices>{_INDICES}*)\Z")
_INDEX = re.compile(r"\[([^\[\]]*)\]")

#: A field's name, an index or a slice.
Step: TypeAlias = "str | int | slice"


class FieldPathError(ZbotError):
    """A path is not valid, or its field does not exist."""

    def __init__(self, path: str, reason: str, hint: str | None = None) -> None:
        self.path = path
        super().__init__(f"Invalid field '{path}': {reason}", hint=hint)


class FieldPath:
    """A dotted path with indices and slices, e.g. `ranges[0]`, `ranges.[0]`, `points[2:5]`.

    Args:
        text: The path.

    Attributes:
        text: The path.

    Raises:
        FieldPathError: The text is not a path.
    """

    def __init__(self, text: str) -> None:
        self.text = text
        self._steps = tuple(self._parse())

    @property
    def names(self) -> list[str]:
        """The names of fields in the path, without indices and slices."""
        return [step for step in self._steps if isinstance(step, str)]

    @property
    def is_list(self) -> bool:
        """Whether the path has a slice, so that its value is a list."""
        return any(isinstance(step, slice) for step in self._steps)

    @property
    def ends_with_index(self) -> bool:
        """Whether the last step is an index."""
        return isinstance(self._steps[-1], int)

    def select(self, message: Any) -> Any:
        """Return the part of a message at the path.

        Raises:
            FieldPathError: The message has no such part.
        """
        value = message
        for step in self._steps:
            try:
                value = follow(value, step)
            except AttributeError as exc:
                raise self._missing(value, step, str(exc)) from None
            except (IndexError, TypeError) as exc:
                raise FieldPathError(self.text, str(exc)) from None
        return value

    def check(self, message_type: type[Any]) -> None:
        """Check that messages of a type can have a part at the path.

        Raises:
            FieldPathError: The path contains a field that the type does not have.
        """
        value = message_type()
        for step in self._steps:
            if isinstance(step, slice):
                return
            try:
                value = follow(value, step)
            except IndexError:
                return  # the list is empty in a new message
            except (AttributeError, TypeError):
                self.select(message_type())

    def _parse(self) -> Sequence[Step]:
        steps: list[Step] = []
        for part in self.text.split("."):
            match = (_LATER_PART if steps else _PART).match(part)
            if match is None:
                raise FieldPathError(self.text, "write it like pose.position.x or ranges[0]")
            steps.extend(filter(None, (match["name"],)))
            steps.extend(self._index(text) for text in _INDEX.findall(match["indices"]))
        return steps

    def _index(self, text: str) -> int | slice:
        try:
            numbers = [int(part) if part.strip() else None for part in text.split(":")]
        except ValueError:
            numbers = []
        if len(numbers) == 1 and numbers[0] is not None:
            return numbers[0]
        if len(numbers) not in {2, 3} or numbers[2:] == [0]:
            raise FieldPathError(self.text, f"[{text}] is not an index")
        return slice(*numbers)

    def _missing(self, value: Any, step: Step, reason: str) -> FieldPathError:
        known = [field.name for field in fields_of(value)]
        hint = did_you_mean(str(step), known)
        if known:
            hint = hint or f"its fields are {', '.join(known)}"
        return FieldPathError(self.text, reason, hint)


def follow(value: Any, step: Step) -> Any:
    """Return a field of a message or elements of a list. Other attributes are not accessible.

    Raises:
        AttributeError: The value has no such field.
        IndexError: The list is too short.
        TypeError: The value is not a list.
    """
    if not isinstance(step, str):
        return value[step]
    if step not in {field.name for field in fields_of(value)}:
        raise AttributeError(f"'{type(value).__name__}' object has no attribute '{step}'")
    return getattr(value, step)


def fields_of(value: Any) -> Sequence[Any]:
    """Return the fields of a message's definition, or an empty list for any other value."""
    if not is_message(value):
        return ()
    fields: Sequence[Any] = spec_of(type(value)).fields  # type: ignore[union-attr]
    return fields


def is_message(value: Any) -> bool:
    """Return whether a value is a message. Numbers, strings and lists are not messages."""
    return hasattr(type(value), "get_fields_and_field_types")
