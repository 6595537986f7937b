"""Search for the types of a domain, repeated for the types that were not found."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.threads.deadline import Deadline

if TYPE_CHECKING:
    from collections.abc import Callable, Container

_FIRST_PAUSE_S = 5.0
_LONGEST_PAUSE_S = 300.0


@dataclass(frozen=True, slots=True)
class _Failure:
    error: ZbotError
    pause_s: float
    pause: Deadline


class TypeSearch:
    """Search for types. A type that was not found is searched for again after a pause.

    The nodes that have the type may have been busy or suspended. The pauses get longer. Only one
    thread may use this.

    Args:
        find: Returns the class of a type, or raises a `ZbotError`. It may ask other machines.
    """

    def __init__(self, find: Callable[[str], Any]) -> None:
        self._find = find
        self._failures: dict[str, _Failure] = {}

    @property
    def is_due(self) -> bool:
        """Whether the pause of a type that was not found is over."""
        return any(failure.pause.is_over for failure in self._failures.values())

    def find(self, type_name: str) -> Any:
        """Return the class of a type. This may take seconds, but not during a pause.

        Raises:
            ZbotError: The type was not found. During a pause, this is the former error.
        """
        known = self._failures.get(type_name)
        if known is not None and not known.pause.is_over:
            raise known.error
        try:
            found = self._find(type_name)
        except ZbotError as error:
            pause_s = min(2 * known.pause_s, _LONGEST_PAUSE_S) if known else _FIRST_PAUSE_S
            self._failures[type_name] = _Failure(error, pause_s, Deadline(pause_s))
            raise
        self._failures.pop(type_name, None)
        return found

    def forget_unused(self, used: Container[str]) -> None:
        """Forget the failures of types that the domain no longer uses."""
        for type_name in [name for name in self._failures if name not in used]:
            del self._failures[type_name]
