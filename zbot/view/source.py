"""Source of what a view shows: a domain, or a bag."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.observer.watch import Watch


class Graph(Protocol):
    """Topics at one moment."""

    def topics(self) -> list[tuple[str, list[str]]]:
        """Return all topics with their types."""
        ...

    def publishers(self, topic: str) -> Sequence[Any]:
        """Return the publishers of a topic."""
        ...


class Source(Protocol):
    """Topics and their messages."""

    revision: int  #: a number that grows with every change of the graph

    def snapshot(self) -> Graph:
        """Return the graph as it is now."""
        ...

    def watch(self, topic: str, type_name: str | None = None, *, keep: int = 0) -> Watch:
        """Return a watch of a topic, which may have no messages yet."""
        ...


class Clock(Protocol):
    """Clock of a view."""

    def look(self, graph: Graph) -> None:
        """Look for publishers of `/clock`."""

    def now_ns(self) -> int:
        """Return the time in nanoseconds since the epoch."""
        ...

    def has_jumped_back(self) -> bool:
        """Return whether all messages must be forgotten, because the time has jumped."""
        ...


class Timeline(Protocol):
    """Recording that is played."""

    length_s: float

    @property
    def position_s(self) -> float:
        """The time since the start."""
        ...

    @property
    def is_playing(self) -> bool:
        """Whether it is played now."""
        ...

    def advance(self) -> None:
        """Take the messages up to the present time."""

    def play(self, is_playing: bool) -> None:
        """Play, or stand still. At the end, play again from the start."""

    def seek(self, position_s: float) -> None:
        """Go to a time since the start."""

    def set_speed(self, speed: float) -> None:
        """Play faster or slower. 1 is the speed of the recording."""
