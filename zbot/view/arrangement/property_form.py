"""Forms of the properties in an `.rviz` file, and what they are in the view."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Protocol

if TYPE_CHECKING:
    from collections.abc import Mapping

    from zbot.view.displays.display import Value
    from zbot.view.shape import Color

_LARGEST = 1e6
_ALL = "All Enabled"


class PropertyError(ValueError):
    """A property of a file has a value that the view cannot use."""


class Form(Protocol):
    """Form of a property."""

    def read(self, raw: Any) -> Value:
        """Return the value of a setting.

        Raises:
            PropertyError: The view cannot use it.
        """
        ...

    def write(self, value: Value) -> Any:
        """Return the value in the file."""
        ...


class Flag:
    """True or false."""

    def read(self, raw: Any) -> Value:
        """Return a bool."""
        if not isinstance(raw, bool):
            raise PropertyError
        return raw

    def write(self, value: Value) -> Any:
        """Return a bool."""
        return bool(value)


class Number:
    """Number from 0, or from a negative number.

    Args:
        factor: The number of the view is the number of the file times this factor.
        low: The smallest number.
    """

    def __init__(self, factor: float = 1.0, low: float = 0.0) -> None:
        self._factor, self._low = factor, low

    def read(self, raw: Any) -> Value:
        """Return a finite number."""
        if isinstance(raw, bool) or not isinstance(raw, (int, float)):
            raise PropertyError
        if not self._low <= raw <= _LARGEST:  # also for NaN
            raise PropertyError
        return round(float(raw) * self._factor, 6)  # rviz writes 0.3 as 0.30000001192092896

    def write(self, value: Value) -> Any:
        """Return a number."""
        return 0.0 if isinstance(value, tuple) else round(float(value) / self._factor, 6)


class Text:
    """Any text."""

    def read(self, raw: Any) -> Value:
        """Return a text. An empty value in the file is an empty text."""
        if raw is not None and not isinstance(raw, (str, int)):
            raise PropertyError
        return "" if raw is None else str(raw)

    def write(self, value: Value) -> Any:
        """Return a text."""
        return str(value)


class Frame(Text):
    """Name of a frame. `<Fixed Frame>` is an empty name in the view."""

    def read(self, raw: Any) -> Value:
        """Return a name."""
        name = str(super().read(raw))
        return "" if name.startswith("<") else name

    def write(self, value: Value) -> Any:
        """Return a name."""
        return str(value) or "<Fixed Frame>"


class Rgb:
    """Colour as a text, e.g. `255; 0; 0`."""

    def read(self, raw: Any) -> Color:
        """Return a colour."""
        try:
            red, green, blue = (int(part) for part in str(raw).split(";"))
        except ValueError:
            raise PropertyError from None
        if not all(0 <= part <= 255 for part in (red, green, blue)):
            raise PropertyError
        return red, green, blue

    def write(self, value: Value) -> Any:
        """Return a text."""
        return "; ".join(map(str, value)) if isinstance(value, tuple) else str(value)


class Choice:
    """Word of a list.

    Args:
        words: The words of the file, and those of the view. For several words of the file with the
            same meaning, the first one is written.
    """

    def __init__(self, words: Mapping[str, str]) -> None:
        self._words = words

    def read(self, raw: Any) -> Value:
        """Return the word of the view."""
        found = self._words.get(raw) if isinstance(raw, str) else None
        if found is None:
            raise PropertyError
        return found

    def write(self, value: Value) -> Any:
        """Return the word of the file."""
        return next((theirs for theirs, ours in self._words.items() if ours == value), str(value))


class Hidden:
    """Names with a switch each. In the view, it is a text with the names that are off.

    Args:
        is_nested: Whether a switch is the property `Value` of its name.
    """

    def __init__(self, *, is_nested: bool = False) -> None:
        self._is_nested = is_nested

    def read(self, raw: Any) -> Value:
        """Return the names that are off, with a space between two names."""
        names = raw if isinstance(raw, dict) else {}
        off = [str(name) for name, state in names.items() if name != _ALL and self._is_off(state)]
        if any(set(name) & {" ", ","} for name in off):
            raise PropertyError
        return " ".join(off)

    def _is_off(self, state: Any) -> bool:
        if self._is_nested:
            return isinstance(state, dict) and state.get("Value") is False
        return state is False

    def write(self, value: Value) -> Any:
        """Return the switches of the names that are off."""
        names = str(value).replace(",", " ").split()
        return {name: {"Value": False} if self._is_nested else False for name in names}


def is_same(raw: Any, usual: Any) -> bool:
    """Return whether a property has a value. Numbers of files are rounded."""
    if isinstance(raw, bool) or isinstance(usual, bool):
        return raw is usual
    if isinstance(raw, (int, float)) and isinstance(usual, (int, float)):
        return math.isclose(raw, usual, rel_tol=1e-4, abs_tol=1e-6)
    return bool((raw or "") == usual)
