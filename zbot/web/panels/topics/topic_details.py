"""Details of one topic, with nodes, last message as tree and picture, and a publish form."""

from __future__ import annotations

from typing import TYPE_CHECKING
from urllib.parse import urlencode

from nicegui import ui

from zbot.errors import counted
from zbot.observer.value_text import amount, tree
from zbot.web.page.message_view import TREE_COLUMNS
from zbot.web.page.table import Cell, Table
from zbot.web.page.topic_picture import add_picture
from zbot.web.panels.topics.publish_form import add_publish_form
from zbot.web.panels.topics.topic_rows import nodes_of

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from zbot.observer.value_text import TreeRow
    from zbot.observer.watch import Watch
    from zbot.web.page.panel import Section

_TREE_HZ = 10.0
_TYPE_HZ = 5.0


def show_topic(section: Section, topic: str, close: Callable[[], None]) -> None:
    """Add a topic's details to the current element.

    Args:
        section: The section of the details. When it is closed, the updates end.
        topic: Full name.
        close: Called when the user closes the details.
    """
    watch = section.watch(topic)
    with ui.element("div").classes("zb-side-head"):
        ui.label(topic).classes("zb-mono zb-name").tooltip(topic)
        ui.button(icon="close", on_click=close).props('flat round dense aria-label="Close"')
    place = ui.element("div").classes("zb-col")
    inner, shown = section.section(), watch.type_name

    def fill() -> None:
        with place:
            _add_facts(inner, watch)
            add_picture(inner, watch)
            _add_tree(inner, watch)
            if not section.page.read_only:
                add_publish_form(inner, watch)

    def follow_type() -> None:
        nonlocal inner, shown
        if watch.type_name in {None, shown}:
            return
        if shown is not None:  # the picture and the form are for another type
            inner.close()
            place.clear()
            inner = section.section()
            fill()
        shown = watch.type_name

    fill()
    section.live(follow_type, _TYPE_HZ)


def _add_facts(section: Section, watch: Watch) -> None:
    kind = ui.label().classes("zb-muted zb-mono")
    numbers = ui.label().classes("zb-muted")
    problem = ui.label().classes("zb-bad")
    with ui.element("div").classes("zb-ends"):
        publishers = _end_list("Published by")
        subscriptions = _end_list("Subscribed by")
    seen = -1

    def update() -> None:
        nonlocal seen
        kind.set_text(watch.type_name or "no node uses this topic")
        numbers.set_text(_numbers(watch))
        problem.set_text(watch.problem)
        problem.set_visibility(bool(watch.problem))
        if section.system.revision != seen:
            seen = section.system.revision
            ends = nodes_of(section.system.snapshot(), watch.topic, section.system.node_name)
            _fill(publishers, ends[0])
            _fill(subscriptions, ends[1])

    section.live(update, 2.0)


def _numbers(watch: Watch) -> str:
    parts = [
        amount(watch.rate_hz, "Hz"),
        amount(watch.bytes_per_second, "B/s"),
        counted(watch.count, "message"),
        f"{watch.lost} lost" if watch.lost else "",
    ]
    return " · ".join(filter(None, parts))


def _end_list(title: str) -> ui.element:
    with ui.element("div"):
        ui.label(title).classes("zb-heading")
        return ui.element("div").classes("zb-chips")


def _fill(chips: ui.element, nodes: Sequence[str]) -> None:
    chips.clear()
    with chips:
        for name in nodes:
            ui.label(name).classes("zb-chip zb-mono")
        if not nodes:
            ui.label("no node").classes("zb-muted")


def _add_tree(section: Section, watch: Watch) -> None:
    ui.label("Last message").classes("zb-heading")
    waiting = ui.label("No message yet.").classes("zb-muted")
    table = Table(section.page, TREE_COLUMNS)
    table.element.classes("zb-tree")
    shown: object = None

    def update() -> None:
        nonlocal shown
        message = watch.latest
        if message is not shown:
            shown = message
            waiting.set_visibility(False)
            rows = tree(message)
            table.show({row.path: _cells(watch.topic, row) for row in rows})
            waiting.set_text("The message has no fields.")
            waiting.set_visibility(not rows)

    section.live(update, _TREE_HZ)


def _cells(topic: str, row: TreeRow) -> list[str | Cell]:
    address = ""
    if row.is_number:
        address = f"/plot?{urlencode({'curve': f'{topic}.{row.path}'})}"
    hint = "show as plot" if address else ""
    name = Cell(row.name, indent=row.depth, address=address, hint=hint)
    return [name, Cell(row.text), Cell(row.type.rpartition("/")[2], hint=row.type)]
