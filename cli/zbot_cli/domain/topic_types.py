"""Types of topics in the graph. A command can wait until a topic has a type."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.names import nearest

if TYPE_CHECKING:
    from zbot.graph.snapshot import Snapshot
    from zbot.node.node import Node


class SeveralTypesError(ZbotError):
    """A topic has more than one type, and the command line names no type."""

    def __init__(self, name: str, types: list[str]) -> None:
        self.name, self.types = name, types
        self.hint = f"add the type that you mean, e.g. zbot topic echo {name} {types[0]}"
        super().__init__(
            f"Cannot echo topic '{name}', as it contains more than one type: [{', '.join(types)}]"
        )


class UndefinedTypeError(ZbotError):
    """The definition of a topic's type was found neither on this machine nor in a node."""

    def __init__(self, type_name: str) -> None:
        self.type_name = type_name
        self.hint = "put its .msg file into a package of your workspace"
        super().__init__(f"The message type '{type_name}' is invalid")


def only_type(graph: Snapshot, name: str) -> str | None:
    """Return the type of a topic, or `None` if no node uses the topic.

    Raises:
        SeveralTypesError: The topic has more than one type.
    """
    types = dict(graph.topics()).get(name)
    if types is None:
        return None
    if len(types) > 1:
        raise SeveralTypesError(name, types)
    return types[0]


def wait_for_type(node: Node, name: str) -> str:
    """Wait until a topic exists, and return its type. Print a note before waiting."""
    graph = node.context.graph
    found = only_type(graph.snapshot(), name)
    if found is None:
        print_waiting(graph.snapshot(), name)
        while found is None and node.context.ok():
            graph.wait_for(lambda snapshot: only_type(snapshot, name) is not None, 0.5)
            found = only_type(graph.snapshot(), name)
    return found or ""


def print_waiting(graph: Snapshot, name: str) -> None:
    """Print on stderr that the command waits for a topic. Add the most similar name if any."""
    known = [topic for topic, _ in graph.topics()]
    guess = nearest(name, known)
    hint = f"; did you mean {guess}?" if guess else ""
    print(f"waiting for {name} to appear{hint}", file=sys.stderr, flush=True)


def message_class(type_name: str) -> type[Any]:
    """Return a message class. If this machine lacks the definition, ask the nodes for it.

    Raises:
        UndefinedTypeError: Neither this machine nor a node has a definition of the type.
    """
    from zbot.interfaces import get_message  # noqa: PLC0415 - not needed by `list`

    try:
        return get_message(type_name)
    except LookupError:
        from zbot_cli.domain.types import learn  # noqa: PLC0415 - only for types of other machines

        if learn(type_name):
            return get_message(type_name)
        raise UndefinedTypeError(type_name) from None
