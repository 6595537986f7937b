"""Buttons of launches and processes, the question before a stop, and the requests."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from nicegui import ui

from zbot.observer.system import read_only_error
from zbot.web.page.service_call import run_in_thread, with_errors_shown

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Mapping

    from zbot.launch.control.running_launch import RunningLaunch
    from zbot.web.page.panel import Section

    Handler = Callable[[], Coroutine[Any, Any, None]]


def add_buttons(section: Section, handlers: Mapping[str, Handler]) -> ui.element:
    """Add a row with a button for each handler. A read-only page has a sentence in its place."""
    with ui.element("div").classes("zb-row") as row:
        if section.page.read_only:
            ui.label("This page is read-only.").classes("zb-muted")
            return row
        for text, handler in handlers.items():
            button = ui.button(text, on_click=with_errors_shown(handler), color=None)
            button.props("outline dense").classes("zb-danger" if "Stop" in text else "")
    return row


def ask_to_confirm(title: str, text: str, word: str, act: Handler) -> None:
    """Ask the user, and call a function if the user confirms. Escape cancels."""
    with ui.dialog() as dialog, ui.card().classes("zb-dialog"):
        dialog.on("hide", dialog.delete)
        ui.label(title).classes("zb-heading")
        ui.label(text).classes("zb-wrap")

        async def confirm() -> None:
            dialog.close()
            await act()

        with ui.element("div").classes("zb-row"):
            ui.button(word, on_click=with_errors_shown(confirm)).props("unelevated dense autofocus")
            ui.button("Cancel", on_click=dialog.close).props("outline dense")
    dialog.open()


async def send(section: Section, launch: RunningLaunch, op: str, **words: str) -> None:
    """Send a request that changes a launch.

    Raises:
        ViewerError: The page is read-only.
        LaunchControlError: The launch has ended, or refuses the request.
    """
    if section.page.read_only:
        raise read_only_error("the control of launches")
    await run_in_thread(lambda: launch.ask(op, **words))
