"""The panel of topics."""

from __future__ import annotations

from nicegui import ui

from zbot.web.panel import Frame, Panel


def _build(frame: Frame) -> None:
    frame.show_command("zbot topic list -t")
    label = ui.label().classes("zb-mono")

    def update() -> None:
        label.set_text(str(frame.system.snapshot().topics()))

    frame.live(update)


PANEL = Panel("/topics", "Topics", "lan", _build)
