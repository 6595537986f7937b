"""Types of topics in the graph. A command can wait until a topic has a type."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

from zbot.errors.suggestion import did_you_mean, similar_names
from zbot.names import fully_qualified
from zbot.threads.deadline import Deadline
from zbot.wire.tokens import EntityKind
from zbot_cli.domain.client import print_stopped_programs
from zbot_cli.errors import CommandError

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from zbot.graph.snapshot import Snapshot
    from zbot.node.node import Node
    from zbot.wire.tokens import EndpointToken

#: Seconds after which a command says that a topic has no publisher or no subscription.
HINT_DELAY_S = 2.0


def only_type(graph: Snapshot, name: str) -> str | None:
    """Return the type of a topic, or `None` if no node uses the topic.

    Raises:
        CommandError: The topic has more than one type.
    """
    types = dict(graph.topics()).get(name)
    if types is None:
        return None
    if len(types) > 1:
        raise CommandError(
            f"Cannot echo topic '{name}', as it contains more than one type: [{', '.join(types)}]",
            hint=f"add the type that you mean, e.g. zbot topic echo {name} {types[0]}",
        )
    return types[0]


def wait_for_type(node: Node, name: str) -> str:
    """Wait until a topic exists, and return its type. Print a note before waiting.

    If the context ends first, return an empty string.
    """
    graph = node.context.graph
    found = only_type(graph.snapshot(), name)
    if found is None:
        hint_time, is_hinted = Deadline(HINT_DELAY_S), print_waiting(graph.snapshot(), name)
        while found is None and node.context.ok():
            graph.wait_for(lambda snapshot: only_type(snapshot, name) is not None, 0.5)
            found = only_type(graph.snapshot(), name)
            if hint_time.is_over and not (found or is_hinted):
                print_missing(graph.snapshot(), name, EntityKind.PUBLISHER)
                is_hinted = True
    return found or ""


def print_waiting(graph: Snapshot, name: str) -> bool:
    """Print on stderr that the command waits for a topic. Add the most similar name if any.

    Returns:
        Whether there is a similar name.
    """
    known = [topic for topic, _ in graph.topics()]
    hint = did_you_mean(name, known, before="; ")
    print(f"waiting for {name} to appear{hint}", file=sys.stderr, flush=True)
    return bool(hint)


def print_silent(name: str, publishers: Sequence[EndpointToken]) -> None:
    """Print on stderr that the publishers of a topic have sent no message yet."""
    who = sorted({fully_qualified(one.namespace, one.node) for one in publishers})
    print(
        f"no message on {name} yet; its publisher is {', '.join(who)}", file=sys.stderr, flush=True
    )


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
    hint = did_you_mean(name, known) or "`zbot topic list` shows the topics"
    verb = "publishes" if kind is EntityKind.PUBLISHER else "subscribes to"
    print(f"nobody {verb} {name}; {hint}", file=sys.stderr, flush=True)


def message_class(type_name: str) -> type[Any]:
    """Return a message class. If this machine lacks the definition, ask the nodes for it.

    Raises:
        CommandError: No definition of the type is on this machine or in a node.
    """
    from zbot.interfaces import get_message  # noqa: PLC0415 - not needed by `list`

    try:
        return get_message(type_name)
    except LookupError:
        from zbot_cli.domain.types import learn  # noqa: PLC0415 - only for types of other machines

        if learn(type_name):
            return get_message(type_name)
        raise CommandError(
            f"The message type '{type_name}' is invalid",
            hint="put its .msg file into a package of your workspace",
        ) from None
