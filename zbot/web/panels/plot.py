"""The panel of plots."""

from __future__ import annotations

from nicegui import ui

from zbot.web.panel import Frame, Panel


def _build(frame: Frame) -> None:
    frame.show_command("zbot plot")
    label = ui.label().classes("zb-mono")

    def update() -> None:
        label.set_text(str(frame.system.snapshot().topics()))

    frame.live(update)


PANEL = Panel("/plot", "Plot", "show_chart", _build)
