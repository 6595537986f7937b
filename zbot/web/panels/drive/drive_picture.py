"""Picture of a camera or a laser scanner above the stick."""

from __future__ import annotations

from typing import TYPE_CHECKING

from nicegui import ui

from zbot.names import is_hidden
from zbot.web.page.topic_picture import PICTURE_TYPES, add_picture
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from zbot.graph.snapshot import Snapshot
    from zbot.web.page.panel import Page, Section

_HZ = 5.0
_NONE = "no picture"


def picture_topics(graph: Snapshot) -> list[str]:
    """Return the topics whose messages the page shows as pictures, cameras first."""
    found = {
        (PICTURE_TYPES.index(end.type_name), end.name)
        for end in graph.of_kind(EntityKind.PUBLISHER)
        if end.type_name in PICTURE_TYPES and not is_hidden(end.name)
    }
    return list(dict.fromkeys(name for _, name in sorted(found)))


class DrivePicture:
    """Picture of the first camera, or of the topic that the user chooses.

    Args:
        page: The page.
    """

    def __init__(self, page: Page) -> None:
        self._page = page
        self._revision = -1
        self._is_chosen = False
        self._shown = _NONE
        self._section: Section | None = None
        with page.toolbar:
            self._chooser = ui.select([_NONE], value=_NONE, on_change=self._show)
            self._chooser.props('dense outlined options-dense aria-label="Picture"')
            self._chooser.on("popup-show", self._choose)
        self._place = ui.element("div").classes("zb-card zb-col zb-drive-picture")
        self._place.set_visibility(False)
        page.live(self._match, _HZ)

    def _choose(self) -> None:
        self._is_chosen = True

    def _match(self) -> None:
        if self._revision == self._page.system.revision:
            return
        self._revision = self._page.system.revision
        topics = picture_topics(self._page.system.snapshot())
        self._chooser.set_visibility(bool(topics) or self._shown != _NONE)
        kept = [] if self._shown == _NONE else [self._shown]
        self._chooser.set_options([_NONE, *sorted({*topics, *kept})])
        if topics and not self._is_chosen and self._shown == _NONE:
            self._chooser.set_value(topics[0])

    def _show(self) -> None:
        topic = str(self._chooser.value or _NONE)
        if topic == self._shown:
            return
        self._shown = topic
        if self._section is not None:
            self._section.close()
        self._place.clear()
        self._place.set_visibility(topic != _NONE)
        if topic != _NONE:
            self._section = self._page.section()
            with self._place:
                add_picture(self._section, self._section.watch(topic))
