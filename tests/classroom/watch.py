"""Watcher of the nodes that a machine's hub sees."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.classroom.machine import Machine


class Watch:
    """Follows the nodes that a hub sees.

    Args:
        machine: Whose hub.
        domains: Only these; all if left out.
    """

    def __init__(self, machine: Machine, *domains: int) -> None:
        self._program = machine.start("watch.py", *map(str, domains))
        self._program.wait_for("watching")
        self.nodes: set[tuple[int, str]] = set()  #: domain and node name

    def until(self, done: Callable[[set[tuple[int, str]]], bool], timeout_s: float = 30) -> float:
        """Wait until `done(nodes)`; return the monotonic time of the event, in seconds."""
        at_ns = 0
        while not done(self.nodes):
            kind, when, domain, node = self._program.wait_for(" ", timeout_s).split()
            change = self.nodes.add if kind == "up" else self.nodes.discard
            change((int(domain), node))
            at_ns = int(when)
        return at_ns / 1e9
