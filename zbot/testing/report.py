"""Text of a failure: what there was in the domain instead of what the test waited for."""

from __future__ import annotations

import inspect
import textwrap
from typing import TYPE_CHECKING, Any

from zbot.errors import counted
from zbot.errors.suggestion import did_you_mean
from zbot.names import is_hidden
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from zbot.context import Context
    from zbot.graph.snapshot import NamesAndTypes, Snapshot
    from zbot.testing.program import Program

_MOST_CHARACTERS = 500  # of one value
_OF_EVERY_NODE = {"/rosout", "/parameter_events"}


def shortened(value: object) -> str:
    """Return the text of a value. A long text is cut."""
    return textwrap.shorten(repr(value), _MOST_CHARACTERS, placeholder=" ...")


def values(condition: Callable[[], object]) -> str:
    """Return the variables of the test that the condition uses, with their values."""
    if not inspect.isfunction(condition):
        return ""
    used = inspect.getclosurevars(condition).nonlocals
    return "\n".join(f"{name} = {shortened(value)}" for name, value in used.items())


def publishers(context: Context, topic: str, type_name: str) -> str:
    """Return why no message may have come: a missing publisher, or a different type."""
    snapshot = context.graph.snapshot()
    types = {publisher.type_name for publisher in snapshot.publishers(topic)}
    if not types:
        published = snapshot.names_and_types(EntityKind.PUBLISHER)
        return "nobody publishes it" + _similar(topic, published)
    return _other_types(types, type_name, "its publishers have")


def servers(context: Context, service: str, type_name: str) -> str:
    """Return why no server was found: a similar name, or a different type."""
    known = context.graph.snapshot().services()
    types = dict(known).get(service, ())
    if not types:
        return _similar(service, known).removeprefix("; ")
    return _other_types(types, type_name, "its server has")


def _similar(name: str, known: NamesAndTypes) -> str:
    return did_you_mean(name, [topic for topic, _ in known if not is_hidden(topic)], before="; ")


def _other_types(types: Iterable[str], type_name: str, who: str) -> str:
    others = ", ".join(sorted(set(types) - {type_name}))
    return f"{who} the type {others}, and the test has {type_name}" if others else ""


def domain(context: Context) -> str:
    """Return the nodes, topics and services of a domain, except for hidden ones."""
    snapshot = context.graph.snapshot()
    names = {f"{node.namespace.rstrip('/')}/{node.node}" for node in snapshot.nodes}
    services = [(name, types) for name, types in snapshot.services() if not _is_usual(name)]
    return "\n".join(
        (
            _listed("nodes", sorted(name for name in names if not is_hidden(name))),
            _listed("topics", _topics(snapshot)),
            _listed("services", [f"{name} [{', '.join(types)}]" for name, types in services]),
        )
    )


def _is_usual(service: str) -> bool:
    """Return whether a service is hidden, or one of the parameter services of each node."""
    words = ("parameter", "type_description", "logger_level")
    return is_hidden(service) or any(word in service.rpartition("/")[2] for word in words)


def _topics(snapshot: Snapshot) -> list[str]:
    return [
        f"{name} [{', '.join(types)}]: {counted(len(snapshot.publishers(name)), 'publisher')}, "
        f"{counted(_visible_subscriptions(snapshot, name), 'subscription')}"
        for name, types in snapshot.topics()
        if not is_hidden(name) and name not in _OF_EVERY_NODE and _is_visible(snapshot, name)
    ]


def _is_visible(snapshot: Snapshot, topic: str) -> bool:
    """Return whether a topic has an endpoint besides those of hidden nodes."""
    return bool(snapshot.publishers(topic)) or _visible_subscriptions(snapshot, topic) > 0


def _visible_subscriptions(snapshot: Snapshot, topic: str) -> int:
    return sum(not is_hidden(subscription.node) for subscription in snapshot.subscriptions(topic))


def _listed(title: str, items: list[str]) -> str:
    return f"{title}:" + ("".join(f"\n  {item}" for item in items) or " none")


def states(programs: Sequence[Program]) -> str:
    """Return for each program whether it runs."""
    codes: list[tuple[Program, Any]] = [(program, program.process.poll()) for program in programs]
    return "\n".join(
        f"`{program}` " + ("is running" if code is None else f"ended with exit code {code}")
        for program, code in codes
    )
