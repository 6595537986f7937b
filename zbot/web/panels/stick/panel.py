"""Panel with two sticks and the buttons of a gamepad, for machines that have no gamepad."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from nicegui import ui

from zbot.errors import ZbotError
from zbot.names import validate_topic_name
from zbot.web.page.command_line import command_line
from zbot.web.page.panel import Page, Panel
from zbot.web.page.service_call import show_error
from zbot.web.panels.stick.stick import BUTTONS, Stick

if TYPE_CHECKING:
    from collections.abc import Callable

    from nicegui.events import JoystickEventArguments

_NAMES = ("Left stick", "Right stick")
_SIZE_PX = 150
_LIVE_HZ = 2.0


class StickPanel:
    """Panel of one browser.

    Args:
        page: The page.
    """

    def __init__(self, page: Page) -> None:
        self._page = page
        self._stick = page.keep(Stick(page.system, page.query.get("topic", "/joy")))
        self._buttons: list[ui.button] = []
        with page.toolbar:
            topic = ui.input(value=self._stick.topic).props('dense outlined aria-label="Topic"')
            topic.on("change", lambda event: self._use_topic(str(event.args)), args=None)
        self._show_command()
        if page.read_only:
            ui.label("This page is read-only: it cannot drive.").classes("zb-muted")
            return
        with ui.element("div").classes("zb-row"):
            for number, name in enumerate(_NAMES):
                self._build_stick(number, name)
        with ui.element("div").classes("zb-card zb-col"):
            ui.label("Buttons stay pressed until the next click.").classes("zb-muted")
            with ui.element("div").classes("zb-row"):
                self._buttons = [self._build_button(number) for number in range(BUTTONS)]
        page.live(self._stick.keep_alive, _LIVE_HZ)

    def _build_stick(self, number: int, name: str) -> None:
        with ui.element("div").classes("zb-card zb-col"):
            ui.label(name).classes("zb-heading")
            stick = ui.joystick(
                on_move=lambda event: self._move(number, event),
                on_end=lambda event: self._move(number, event),
                size=_SIZE_PX,
                mode="static",
                position={"left": "50%", "top": "50%"},
            )
            stick.props(f'role="group" aria-label="{name}"').style(
                f"position: relative; width: {_SIZE_PX + 40}px; height: {_SIZE_PX + 40}px"
            )

    def _build_button(self, number: int) -> ui.button:
        button = ui.button(str(number), on_click=partial(self._press, number), color=None)
        return button.props("outline dense").classes("zb-key")

    def _move(self, number: int, event: JoystickEventArguments) -> None:
        self._safely(lambda: self._stick.move(number, event.x or 0.0, event.y or 0.0))

    def _press(self, number: int) -> None:
        is_pressed = not self._stick.buttons[number]
        self._safely(lambda: self._stick.press(number, is_pressed=is_pressed))
        self._buttons[number].props(f"aria-pressed={str(is_pressed).lower()}")
        if is_pressed:
            self._buttons[number].props(remove="outline")
        else:
            self._buttons[number].props("outline")

    def _use_topic(self, topic: str) -> None:
        def use() -> None:
            validate_topic_name(topic)
            self._stick.release()
            self._stick.topic = topic if topic.startswith("/") else f"/{topic}"
            self._page.set_query(topic=self._stick.topic)
            self._show_command()

        self._safely(use)

    def _show_command(self) -> None:
        self._page.show_command(command_line("topic", "echo", self._stick.topic))

    @staticmethod
    def _safely(act: Callable[[], object]) -> None:
        try:
            act()
        except ZbotError as error:
            show_error(error)


def _build(page: Page) -> None:
    StickPanel(page)


PANEL = Panel("/stick", "Stick", "sports_esports", _build)
