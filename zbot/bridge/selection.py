"""Selection of the topics, services and actions that a bridge carries, and of their rates."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from enum import Enum
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from zbot.bridge.errors import PatternError
from zbot.names import ACTION_PART, is_hidden

if TYPE_CHECKING:
    from collections.abc import Iterable

#: Topics that every node has.
_NODE_TOPICS = frozenset({"/rosout", "/parameter_events"})
#: Packages with the types of the services that every node has.
_NODE_SERVICES = ("rcl_interfaces/srv/", "type_description_interfaces/srv/")


class Direction(str, Enum):
    """Direction of the messages of a topic. For a service: from its server to its clients."""

    IN = "in"  #: from ROS 2 to zbot
    OUT = "out"  #: from zbot to ROS 2


@dataclass(frozen=True)
class Pattern:
    """Pattern of names, with `*` for any characters, and the direction that it is for."""

    text: str
    direction: Direction | None = None  #: `None` means both

    @classmethod
    def parse(cls, text: str) -> Pattern:
        """Return the pattern in a text such as `/camera/*`, `/scan:in` or `/cmd_vel:out`.

        Raises:
            PatternError: The direction is not `in` or `out`, or there is no name.
        """
        name, colon, direction = text.partition(":")
        if not name:
            raise PatternError(text, "a name or a pattern such as '/camera/*' is needed")
        if colon and direction not in {way.value for way in Direction}:
            raise PatternError(text, "after the colon, write in (to zbot) or out (to ROS 2)")
        full = name if name.startswith(("/", "*")) else f"/{name}"
        return cls(full, Direction(direction) if colon else None)

    def matches(self, name: str, direction: Direction) -> bool:
        """Return whether this pattern selects a name of ROS 2 in a direction."""
        return self.direction in {None, direction} and fnmatchcase(name, self.text)


def patterns(texts: Iterable[str] | None) -> tuple[Pattern, ...]:
    """Return the patterns in texts. Raise `PatternError` if one is not valid."""
    return tuple(map(Pattern.parse, texts or ()))


def read_rate(text: str) -> tuple[Pattern, float]:
    """Return the pattern and the rate (hertz) in a text such as `/camera/*=5`.

    Raises:
        PatternError: The rate is missing or is not a number above 0.
    """
    name, _, number = text.rpartition("=")
    try:
        rate = float(number)
    except ValueError:
        rate = math.nan
    if not name or not 0 < rate < math.inf:
        raise PatternError(text, "write a topic, an equals sign and messages per second: /image=5")
    return Pattern.parse(name), rate


@dataclass(frozen=True)
class Selection:
    """Patterns for what a bridge carries. They are compared with the names in ROS 2.

    Without patterns, the bridge carries everything except for hidden names and for the topics and
    services that every node has. With one pattern or more, the bridge carries only the names that a
    pattern selects. So with a pattern for topics only, it carries no services and actions.
    """

    topics: tuple[Pattern, ...] = ()
    services: tuple[Pattern, ...] = ()
    actions: tuple[Pattern, ...] = ()
    excluded: tuple[Pattern, ...] = ()
    parameters: bool = False  #: whether services and events of parameters are carried too
    rates: tuple[tuple[Pattern, float], ...] = field(default=())

    @property
    def _is_everything(self) -> bool:
        return not (self.topics or self.services or self.actions)

    def takes_topic(self, name: str, direction: Direction) -> bool:
        """Return whether a topic is carried in a direction."""
        if ACTION_PART in name:
            return self._takes_action(name, direction)
        if self.parameters and name == "/parameter_events":
            return True
        usual = name not in _NODE_TOPICS and not is_hidden(name)
        return self._takes(self.topics, name, direction, usual=usual)

    def takes_service(self, name: str, type_name: str, direction: Direction) -> bool:
        """Return whether a service is offered in a direction."""
        if ACTION_PART in name:
            return self._takes_action(name, direction)
        if self.parameters and type_name.startswith("rcl_interfaces/srv/"):
            return True
        usual = not type_name.startswith(_NODE_SERVICES) and not is_hidden(name)
        return self._takes(self.services, name, direction, usual=usual)

    def _takes_action(self, name: str, direction: Direction) -> bool:
        action = name.partition(ACTION_PART)[0]
        return self._takes(self.actions, action, direction, usual=not is_hidden(action))

    def _takes(
        self, wanted: tuple[Pattern, ...], name: str, direction: Direction, *, usual: bool
    ) -> bool:
        if any(pattern.matches(name, direction) for pattern in self.excluded):
            return False
        if self._is_everything:
            return usual
        for pattern in wanted:
            # A hidden name, or a name that every node has, e.g. `/rosout`, is carried only if it
            # is written out in a pattern without `*`.
            if pattern.matches(name, direction) and (usual or "*" not in pattern.text):
                return True
        return False

    def rate(self, name: str, direction: Direction) -> float:
        """Return a topic's largest rate (messages per second), or 0 without a limit."""
        return next((hz for pattern, hz in self.rates if pattern.matches(name, direction)), 0.0)
