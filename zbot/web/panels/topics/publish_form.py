"""Form that publishes a message of a topic's type, once or at a rate."""

from __future__ import annotations

import shlex
from typing import TYPE_CHECKING, Any

from nicegui import ui

from zbot.errors import ZbotError
from zbot.web.forms.form_view import FormView
from zbot.web.page.service_call import run_in_thread

if TYPE_CHECKING:
    from zbot.observer.shared_entities import RepeatedPublishing
    from zbot.observer.watch import Watch
    from zbot.web.page.panel import Section

_FASTEST_HZ = 1000.0


def add_publish_form(section: Section, watch: Watch) -> None:
    """Add a form for a topic's messages. Its inputs appear when the topic's type is known."""
    # The form is open at first if the topic has no publisher.
    is_open = not section.system.snapshot().publishers(watch.topic)
    expansion = ui.expansion("Publish", icon="send", value=is_open)
    expansion.classes("zb-publish").props("dense")
    type_name: str | None = None

    async def update() -> None:
        try:
            message_type = await run_in_thread(section.system.interface, str(type_name))
        except ZbotError as error:
            with expansion:
                ui.label(str(error)).classes("zb-bad")
            return
        with expansion:
            _PublishForm(section, watch.topic, str(type_name), message_type)

    def look() -> None:
        nonlocal type_name
        if watch.type_name is not None:
            type_name = watch.type_name
            undo()
            with expansion:  # the end of the details ends the timer
                ui.timer(0, update, once=True)

    undo = section.live(look, 5.0)


class _PublishForm:
    def __init__(self, section: Section, topic: str, type_name: str, message_type: Any) -> None:
        self.section, self.topic, self.type_name = section, topic, type_name
        self.repetition: RepeatedPublishing | None = None
        self.view = FormView(message_type, self.changed)
        with ui.element("div").classes("zb-row"):
            self.once = ui.button("Publish once", on_click=self.publish).props("unelevated dense")
            self.rate = ui.number("Hz", value=10, min=0.01, max=_FASTEST_HZ, on_change=self.changed)
            self.rate.props('dense outlined aria-label="Rate in Hz"').classes("zb-rate")
            self.repeat = ui.button("Repeat", on_click=self.toggle).props("outline dense")
            self.said = ui.label().classes("zb-muted")

    def changed(self) -> None:
        """Use the changed inputs, so that a repeated message changes immediately."""
        is_right = not self.view.problems
        self.once.set_enabled(is_right)
        self.repeat.set_enabled(is_right or self.repetition is not None)
        if is_right:
            self.show_command()
            if self.repetition is not None:
                self.repetition.change(self.view.maker(), self.rate_hz)

    @property
    def rate_hz(self) -> float:
        """Messages a second. The nearest possible value replaces an impossible value."""
        return min(max(float(self.rate.value or 1.0), 0.01), _FASTEST_HZ)

    def show_command(self) -> None:
        """Show the command that publishes the same message."""
        how = f"-r {self.rate_hz:g}" if self.repetition is not None else "--once"
        words = [self.topic, self.type_name, self.view.yaml()]
        self.section.page.show_command(f"zbot topic pub {how} {shlex.join(words)}")

    def publish(self) -> None:
        if self.view.problems:
            return
        with self.section.system.publisher(self.topic, self.type_name) as reference:
            reference.entity.publish(self.view.message())
        self.said.set_text("published")
        self.show_command()

    def toggle(self) -> None:
        if self.repetition is None:
            if self.view.problems:
                return
            repeat, make = self.section.system.repeat, self.view.maker()
            repetition = repeat(self.topic, self.type_name, make, self.rate_hz)
            self.repetition = self.section.keep(repetition)
            self.repeat.set_text("Stop")
            self.said.set_text("publishing")
        else:
            self.section.drop(self.repetition)
            self.repetition = None
            self.repeat.set_text("Repeat")
            self.said.set_text("")
        self.changed()
