"""Details of a node, topic or action that the user clicked in the graph."""

from __future__ import annotations

import shlex
from typing import TYPE_CHECKING
from urllib.parse import urlencode

from nicegui import ui

from zbot.graph.filters import Grouping
from zbot.graph.topics import BoxKind, find_topics
from zbot.graph.view import node_key
from zbot.names import is_hidden
from zbot.web.panels.topics.topic_details import show_topic
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from zbot.graph.snapshot import Snapshot
    from zbot.graph.topics import TopicView
    from zbot.web.page.panel import Section

_ENDS = (
    ("Publishes", EntityKind.PUBLISHER),
    ("Subscribes to", EntityKind.SUBSCRIPTION),
    ("Serves", EntityKind.SERVICE),
    ("Calls", EntityKind.CLIENT),
)
# Topics and services that every node has. The details do not list them.
_COMMON = frozenset(
    {
        "describe_parameters",
        "get_parameter_types",
        "get_parameters",
        "get_type_description",
        "list_parameters",
        "parameter_events",
        "rosout",
        "set_parameters",
        "set_parameters_atomically",
    }
)


def show_details(section: Section, key: str, close: Callable[[], None]) -> str:
    """Add the details of a node, topic or action to the current element.

    Args:
        section: The section of the details. When it is closed, the updates end.
        key: The key in the drawing, e.g. `n:/talker`.
        close: Called when the user closes the details.

    Returns:
        The command that prints the same details. It is empty if the key has no details.
    """
    kind, _, name = key.partition(":")
    quoted = shlex.quote(name)
    if kind == node_key("")[0]:
        _show_node(section, name, close)
        return f"zbot node info {quoted}"
    if kind == BoxKind.TOPIC.key("")[0]:
        show_topic(section, name, close)
        return f"zbot topic info {quoted} --verbose"
    if kind == BoxKind.ACTION.key("")[0]:
        _show_box(section, key, close)
        return f"zbot action info {quoted} -t"
    if kind in {BoxKind.TF.key("")[0], BoxKind.IMAGES.key("")[0]}:
        _show_box(section, key, close)
        return "zbot topic list -t"
    return ""


def _head(name: str, close: Callable[[], None]) -> None:
    with ui.element("div").classes("zb-side-head"):
        ui.label(name).classes("zb-mono zb-name").tooltip(name)
        ui.button(icon="close", on_click=close).props('flat round dense aria-label="Close"')


def _show_node(section: Section, name: str, close: Callable[[], None]) -> None:
    _head(name, close)
    body = ui.element("div").classes("zb-col")

    def fill(snapshot: Snapshot) -> None:
        count = sum(node.full_node_name == name for node in snapshot.nodes)
        if not count:
            ui.label("This node is not running.").classes("zb-muted")
        if count > 1:
            ui.label(f"{count} nodes have this name.").classes("zb-bad")
        for title, kind in _ENDS:
            found = snapshot.names_and_types(kind, node=name)
            shown = [(entity, types) for entity, types in found if _is_own(entity)]
            if shown:
                ui.label(title).classes("zb-heading")
                for entity, types in shown:
                    is_topic = kind in {EntityKind.PUBLISHER, EntityKind.SUBSCRIPTION}
                    _add_name(entity, ", ".join(types), is_link=is_topic)

    _keep_filled(section, body, fill)


def _is_own(name: str) -> bool:
    return not is_hidden(name) and name.rpartition("/")[2] not in _COMMON


def _show_box(section: Section, key: str, close: Callable[[], None]) -> None:
    _head(key.partition(":")[2], close)
    body = ui.element("div").classes("zb-col")

    def fill(snapshot: Snapshot) -> None:
        nodes = {node.full_node_name for node in snapshot.nodes}
        boxes = {topic.key: topic for topic in find_topics(snapshot, nodes, Grouping())}
        if key in boxes:
            _add_box(boxes[key])
        else:
            ui.label("No node uses it.").classes("zb-muted")

    _keep_filled(section, body, fill)


def _add_box(box: TopicView) -> None:
    for type_name in box.types:
        ui.label(type_name).classes("zb-muted zb-mono")
    if box.problem:
        ui.label(box.problem).classes("zb-bad")
    is_action = box.kind is BoxKind.ACTION
    with ui.element("div").classes("zb-ends"):
        _add_names("Called by" if is_action else "Published by", box.publishers)
        _add_names("Served by" if is_action else "Subscribed by", box.subscriptions)
    if box.stands_for:
        ui.label("Topics in this box").classes("zb-heading")
        for name in box.stands_for:
            _add_name(name, "", is_link=True)


def _add_names(title: str, names: Iterable[str]) -> None:
    with ui.element("div"):
        ui.label(title).classes("zb-heading")
        with ui.element("div").classes("zb-chips"):
            shown = [name for name in names if not is_hidden(name)]
            for name in shown:
                ui.label(name).classes("zb-chip zb-mono")
            if not shown:
                ui.label("no node").classes("zb-muted")


def _add_name(name: str, hint: str, *, is_link: bool) -> None:
    with ui.element("div").classes("zb-graph-name"):
        if is_link:
            ui.link(name, f"/topics?{urlencode({'topic': name})}").classes("zb-mono")
        else:
            ui.label(name).classes("zb-mono")
        ui.label(hint).classes("zb-muted zb-mono")


def _keep_filled(section: Section, body: ui.element, fill: Callable[[Snapshot], None]) -> None:
    seen = -1

    def update() -> None:
        nonlocal seen
        if section.system.revision != seen:
            seen = section.system.revision
            body.clear()
            with body:
                fill(section.system.snapshot())

    section.live(update, 2.0)
