"""Waiting for a time or for a name in the graph, and what a command says on stderr meanwhile."""

from __future__ import annotations

import sys
import time
from functools import partial
from typing import TYPE_CHECKING

from zbot.errors import ExternalShutdownException
from zbot.errors.suggestion import similar_names
from zbot.threads.deadline import Deadline
from zbot.threads.wakeup import BinarySemaphore
from zbot.wire.tokens import EntityKind
from zbot_cli.domain.client import has_nobody, nobody_runs, print_stopped_programs
from zbot_cli.domain.kinds import TOPIC, text_of_other_kind
from zbot_cli.input.domain_names import as_typed, did_you_mean, where_to_look

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from zbot.context import Context
    from zbot.graph.snapshot import Snapshot
    from zbot.node.node import Node
    from zbot.wire.tokens import EndpointToken
    from zbot_cli.domain.kinds import Kind

#: Seconds after which a command says that nobody is there for its topic, service or action.
HINT_DELAY_S = 2.0
_MADE_UP_S = 0.1  # a delay that shortens the next sleeps, so that the mean rate is exact


def wait_for_type(node: Node, kind: Kind, name: str) -> str:
    """Wait until a topic, service or action exists, and return its type. Print a note before.

    Raises:
        CommandError: The name has more than one type.
        ExternalShutdownException: The context ended first.
    """
    find = partial(kind.only_type, name=name)
    graph = node.context.graph.snapshot()
    found = find(graph)
    if found is None:
        has_hint = print_waiting(kind, graph, name)
        if kind is TOPIC and not has_hint:
            found = wait_until_found(node, find, Deadline(HINT_DELAY_S))
            if found is None:
                print_missing(node.context.graph.snapshot(), name, EntityKind.PUBLISHER)
    return found or wait_until_found(node, find, Deadline(None)) or ""


def wait_until_found(
    node: Node, find: Callable[[Snapshot], str | None], deadline: Deadline
) -> str | None:
    """Return what a function finds in the graph, or `None` if it finds nothing in time.

    Raises:
        ExternalShutdownException: The context ended first.
    """
    graph = node.context.graph
    while (found := find(graph.snapshot())) is None and not deadline.is_over:
        graph.wait_for(lambda now: find(now) is not None, deadline.left_s)
        if not node.context.ok():
            raise ExternalShutdownException
    return found


def wait_for_server(
    node: Node, kind: Kind, name: str, find: Callable[[Snapshot], str | None], deadline: Deadline
) -> str | None:
    """Do as `wait_until_found` for a server. Print on stderr after two seconds that it is missing.

    Raises:
        ExternalShutdownException: The context ended first.
    """
    found = wait_until_found(node, find, Deadline(min(deadline.left_s, HINT_DELAY_S)))
    if found is None and not deadline.is_over:
        print_no_server(kind, node.context.graph.snapshot(), name)
        found = wait_until_found(node, find, deadline)
    return found


def print_no_server(kind: Kind, graph: Snapshot, name: str) -> None:
    """Print on stderr that a command waits for a server, and where to look for the right name."""
    noun = kind.word
    where = nobody_runs() if has_nobody(graph) else where_to_look(noun)
    text = f"nobody serves {as_typed(name)}; {kind.suggestion(graph, name) or where}"
    print(text, file=sys.stderr, flush=True)


def print_waiting(kind: Kind, graph: Snapshot, name: str) -> bool:
    """Print on stderr that the command waits for a name, and which similar name there is.

    Returns:
        Whether there is a similar name, or e.g. a service of this name.
    """
    hint = kind.suggestion(graph, name, "; ")
    print(f"waiting for {as_typed(name)} to appear{hint}", file=sys.stderr, flush=True)
    return bool(hint)


def print_hint_if_not_listed(kind: Kind, graph: Snapshot, name: str) -> None:
    """Print the most similar name on stderr if `list` does not show a name."""
    hint = kind.suggestion(graph, name)
    if hint and name not in dict(kind.listed(graph)):
        print(f"hint: {hint}", file=sys.stderr, flush=True)


def print_silent(name: str, publishers: Sequence[EndpointToken]) -> None:
    """Print on stderr that the publishers of a topic have sent no message yet."""
    who = sorted({publisher.full_node_name for publisher in publishers})
    text = f"no message on {as_typed(name)} yet; its publisher is {', '.join(map(as_typed, who))}"
    print(text, file=sys.stderr, flush=True)


def hint_if_silent(
    node: Node,
    names: Sequence[str],
    is_silent: Callable[[], bool],
    *,
    is_measured: bool = False,
) -> None:
    """After two seconds without a message, print on stderr which topics have no publisher.

    The node's executor must spin. Each topic is named at most once for each of both reasons.

    Args:
        node: The node of the command.
        names: The topics that the command listens to.
        is_silent: Function that returns whether no message has arrived. Messages may arrive from
            plain Zenoh programs, which do not appear in the graph.
        is_measured: Whether a topic is named too if it has a publisher that has sent nothing, also
            if this publisher comes later.
    """
    from zbot.executor.clock import Clock  # noqa: PLC0415 - needed only by commands that listen
    from zbot.time import ClockType  # noqa: PLC0415 - as above

    silent, missing = list(names), set[str]()

    def check() -> None:
        if not is_silent():
            timer.cancel()
            return
        if not missing:
            print_stopped_programs()
        graph = node.context.graph.snapshot()
        for name in tuple(silent):
            if publishers := graph.publishers(name):
                silent.remove(name)
                if is_measured:
                    print_silent(name, publishers)
            elif name not in missing:
                missing.add(name)
                print_missing(graph, name, EntityKind.PUBLISHER)
        if not (silent and is_measured):  # a measured topic may get a publisher that sends nothing
            timer.cancel()

    timer = node.create_timer(HINT_DELAY_S, check, clock=Clock(clock_type=ClockType.STEADY_TIME))


def print_missing(graph: Snapshot, name: str, kind: EntityKind) -> None:
    """Print on stderr that a topic has no publisher or no subscription. Add the most similar name.

    Args:
        graph: The graph.
        name: The topic. If it has an endpoint of the kind, nothing is printed.
        kind: PUBLISHER or SUBSCRIPTION.
    """
    if graph.on(name, kind):
        return
    known = [topic for topic, _ in graph.names_and_types(kind)]
    known = known if similar_names(name, known) else [topic for topic, _ in graph.topics()]
    other = text_of_other_kind(graph, name, TOPIC.word)
    hint = other or did_you_mean(name, known) or where_to_look("topic")
    verb = "publishes" if kind is EntityKind.PUBLISHER else "subscribes to"
    print(f"nobody {verb} {as_typed(name)}; {hint}", file=sys.stderr, flush=True)


class Sleep:
    """Sleep until a point in time. It also ends when its context ends, e.g. after Ctrl-C."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self._end = BinarySemaphore()  # set by a signal handler, in which an Event could deadlock
        context.add_waker(self._end.set)

    def until(self, time_s: float) -> None:
        """Wait until `time.monotonic()` reaches `time_s`, or the context ends."""
        while self._context.ok() and (left := time_s - time.monotonic()) > 0:
            self._end.wait(left)


class PeriodicSleep(Sleep):
    """Sleep until the next period begins. The first period begins now.

    Periods that pass without a sleep are left out, e.g. while the program is suspended. Otherwise
    the command would then do the work of all these periods at once.

    Args:
        context: The end of this context ends a sleep.
        rate_hz: Number of periods per second.
    """

    def __init__(self, context: Context, rate_hz: float) -> None:
        super().__init__(context)
        self._period_s = 1 / rate_hz
        self._next_s = time.monotonic()

    def until_next(self) -> None:
        """Wait until the next period begins, or the context ends."""
        self._next_s += self._period_s
        now_s = time.monotonic()
        if now_s - self._next_s > max(self._period_s, _MADE_UP_S):
            self._next_s = now_s
        self.until(self._next_s)
