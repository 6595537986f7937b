"""The type of a topic: what the graph knows, waited for when nobody is there yet."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.names import nearest

if TYPE_CHECKING:
    from zbot.graph.snapshot import Snapshot
    from zbot.node.node import Node


class SeveralTypesError(ZbotError):
    """A topic has more than one type, and none was named."""

    def __init__(self, name: str, types: list[str]) -> None:
        self.name, self.types = name, types
        self.hint = f"name the one you mean: zbot topic echo {name} {types[0]}"
        super().__init__(
            f"Cannot echo topic '{name}', as it contains more than one type: [{', '.join(types)}]"
        )


class UndefinedTypeError(ZbotError):
    """A topic's type has no definition on this machine."""

    def __init__(self, type_name: str) -> None:
        self.type_name = type_name
        self.hint = "put its .msg file into a package of your workspace, or look at it with --raw"
        super().__init__(f"The message type '{type_name}' is invalid")


def only_type(graph: Snapshot, name: str) -> str | None:
    """Return the type of a topic, `None` if nobody uses the topic.

    Raises:
        SeveralTypesError: It has several.
    """
    types = dict(graph.topics()).get(name)
    if types is None:
        return None
    if len(types) > 1:
        raise SeveralTypesError(name, types)
    return types[0]


def wait_for_type(node: Node, name: str) -> str:
    """Return the type of a topic, waiting until somebody uses it; a note on stderr says so."""
    graph = node.context.graph
    found = only_type(graph.snapshot(), name)
    if found is None:
        tell_waiting(graph.snapshot(), name)
        while found is None and node.context.ok():
            graph.wait_for(lambda snapshot: only_type(snapshot, name) is not None, 0.5)
            found = only_type(graph.snapshot(), name)
    return found or ""


def tell_waiting(graph: Snapshot, name: str) -> None:
    """Say on stderr that nobody uses a topic yet."""
    known = [topic for topic, _ in graph.topics()]
    guess = nearest(name, known)
    hint = f"; did you mean {guess}?" if guess else ""
    print(f"waiting for {name} to appear{hint}", file=sys.stderr, flush=True)


def message_class(type_name: str) -> type[Any]:
    """Return a message class; what this machine does not know, the nodes that use it tell.

    Raises:
        UndefinedTypeError: There is no definition of the type.
    """
    from zbot.interfaces import get_message  # noqa: PLC0415 - lists do without

    try:
        return get_message(type_name)
    except LookupError:
        from zbot_cli.domain.types import learn  # noqa: PLC0415 - only for types of other machines

        if learn(type_name):
            return get_message(type_name)
        raise UndefinedTypeError(type_name) from None
