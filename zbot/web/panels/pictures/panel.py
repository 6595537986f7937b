"""Panel of pictures: several topics of images side by side, each with its rate and latency."""

from __future__ import annotations

from typing import TYPE_CHECKING

from nicegui import ui

from zbot.names import is_hidden
from zbot.observer.image_encoder import IMAGE_TYPES
from zbot.web.page.command_line import command_line
from zbot.web.page.panel import Page, Panel
from zbot.web.panels.pictures.picture_tile import PictureTile
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot.graph.snapshot import Snapshot

_HZ = 5.0
#: How many topics are shown at first, if the address names none.
_FIRST = 4
_MOST = 12


def image_topics(graph: Snapshot) -> list[str]:
    """Return the topics on which nodes publish images, sorted."""
    return sorted(
        {
            end.name
            for end in graph.of_kind(EntityKind.PUBLISHER)
            if end.type_name in IMAGE_TYPES and not is_hidden(end.name)
        }
    )


class PicturesPanel:
    """The tiles, and the list of topics that can be added."""

    def __init__(self, page: Page) -> None:
        self._page = page
        self._revision = -1
        self._tiles: dict[str, PictureTile] = {}
        self._is_chosen = "topics" in page.query
        with page.toolbar:
            self._adder = ui.select([], label="Add a topic", on_change=self._on_choice)
            self._adder.props("dense outlined options-dense").classes("zb-picture-topic")
        self._empty = ui.label("No images yet: start a camera, e.g. zbot run robot_camera")
        self._empty.classes("zb-empty")
        self._grid = ui.element("div").classes("zb-pictures")
        page.show_command(command_line("topic", "list", "-t"))
        for topic in filter(None, page.query.get("topics", "").split(",")[:_MOST]):
            self._add(topic)
        page.live(self._match, _HZ)

    def _match(self) -> None:
        """Offer the topics of the graph, and show the first ones until the user has chosen."""
        if self._revision == self._page.system.revision:
            return
        self._revision = self._page.system.revision
        found = image_topics(self._page.system.snapshot())
        if not self._is_chosen:
            for topic in found[: max(0, _FIRST - len(self._tiles))]:
                self._add(topic)
        self._offer(found)

    def _offer(self, found: Iterable[str]) -> None:
        options = [topic for topic in found if topic not in self._tiles]
        self._adder.set_options(options, value=None)
        self._adder.set_visibility(bool(options) and len(self._tiles) < _MOST)
        self._empty.set_visibility(not self._tiles)

    def _on_choice(self) -> None:
        topic = str(self._adder.value or "")
        if topic:
            self._add(topic)
            self._keep()

    def _add(self, topic: str) -> None:
        if topic not in self._tiles:
            with self._grid:
                self._tiles[topic] = PictureTile(self._page, topic, lambda: self._close(topic))

    def _close(self, topic: str) -> None:
        self._tiles.pop(topic).close()
        self._keep()

    def _keep(self) -> None:
        """Put the shown topics into the address."""
        self._is_chosen = True
        self._revision = -1
        self._page.set_query(topics=",".join(self._tiles))
        self._page.show_command(command_line("topic", "hz", *list(self._tiles)[:1]))


def _build(page: Page) -> None:
    PicturesPanel(page)


PANEL = Panel("/pictures", "Pictures", "photo_camera", _build)
