"""Tile with the pictures of one topic, their rate and their latency."""

from __future__ import annotations

from typing import TYPE_CHECKING

from nicegui import ui

from zbot.web.page.encoded_picture import newest_picture
from zbot.web.panels.pictures.latency import has_simulated_time, latency_text

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.observer.watch import Watch
    from zbot.web.page.encoded_picture import Picture
    from zbot.web.page.panel import Page

_PICTURE_HZ = 10.0
_FACTS_HZ = 2.0


class PictureTile:
    """Tile of a topic, until `close`.

    Args:
        page: The page.
        topic: The topic's full name.
        on_close: Called when the user closes the tile.
    """

    def __init__(self, page: Page, topic: str, on_close: Callable[[], None]) -> None:
        self._page, self._topic = page, topic
        self._section = page.section()
        self._watch: Watch | None = self._section.watch(topic)
        self._shown: Picture | None = None
        self._size = self._latency = ""
        self._element = ui.element("figure").classes("zb-card zb-col zb-picture-tile")
        with self._element:
            with ui.element("div").classes("zb-row zb-picture-head"):
                ui.label(topic).classes("zb-mono zb-name zb-grow")
                self._pause = ui.button(icon="pause", on_click=self._switch)
                close = ui.button(icon="close", on_click=on_close)
            self._picture = ui.element("img")
            self._picture.set_visibility(False)
            self._said = ui.element("figcaption").classes("zb-muted")
            with self._said:
                self._facts = ui.label("No picture yet")
        # A quote in the name of a topic stays a quote.
        self._pause.props("flat round dense").props["aria-label"] = f"Pause {topic}"
        close.props("flat round dense").props["aria-label"] = f"Close {topic}"
        self._picture.props["alt"] = topic
        self._section.live(self._draw, _PICTURE_HZ)
        self._section.live(self._say, _FACTS_HZ)

    def close(self) -> None:
        """Remove the tile."""
        self._section.close()
        self._element.delete()

    def _switch(self) -> None:
        """Pause the pictures, or go on. During a pause, no messages come."""
        if self._watch is not None:
            self._section.drop(self._watch)
            self._watch = None
        else:
            self._watch = self._section.watch(self._topic)
        is_paused = self._watch is None
        word = "Go on with" if is_paused else "Pause"
        self._pause.set_icon("play_arrow" if is_paused else "pause")
        self._pause.props["aria-label"] = f"{word} {self._topic}"
        self._pause.update()
        self._say()

    def _draw(self) -> None:
        newest = None if self._watch is None else newest_picture(self._watch)
        if newest is None or newest is self._shown:
            return
        self._shown = newest
        self._latency, self._size = "", newest.text
        if newest.address:
            received_ns = newest.record.received_ns
            is_simulated = has_simulated_time(self._page.system.snapshot())
            self._latency = latency_text(newest.message, received_ns, is_simulated=is_simulated)
            self._picture.set_visibility(True)
            self._page.call("zbot.showPicture", self._picture.id, newest.address)

    def _say(self) -> None:
        self._facts.set_text(self._sentence())

    def _sentence(self) -> str:
        watch = self._watch
        if watch is None:
            return f"paused, {self._size}" if self._size else "paused"
        if watch.problem:
            return watch.problem
        if self._shown is None:
            return "No picture yet"
        return ", ".join(filter(None, (f"{watch.rate_hz:.1f} Hz", self._latency, self._size)))
