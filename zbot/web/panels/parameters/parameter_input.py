"""Row of one parameter in the page, with name, type, description and an input."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from nicegui import ui

from zbot.errors import ZbotError
from zbot.interfaces.message_reader import FieldMisfitError
from zbot.parameters.parameter import Parameter
from zbot.web.page.command_line import command_line
from zbot.web.page.service_call import run_in_thread, with_errors_shown
from zbot.web.panels.parameters.described_parameter import (
    has_long_value,
    set_value,
    show_value,
)

if TYPE_CHECKING:
    from collections.abc import Awaitable, Callable

    from nicegui.events import GenericEventArguments

    from zbot.web.page.panel import Section
    from zbot.web.panels.parameters.described_parameter import DescribedParameter, Range

#: Seconds between two values while the user drags a slider.
_DRAG_S = 0.1
_STEPS = 200  # number of a slider's steps if the range does not define a step


class ParameterInput:
    """Row for one parameter. The constructor adds it to the current element.

    Args:
        section: The section of the page.
        node: The node's full name.
        parameter: The parameter and its description.
        label: The name that is shown.
        beside: Function that returns a text for a value, which is shown beside it.
    """

    def __init__(
        self,
        section: Section,
        node: str,
        parameter: DescribedParameter,
        *,
        label: str,
        beside: Callable[[DescribedParameter, Any], str] | None = None,
    ) -> None:
        self._section, self._node, self._parameter = section, node, parameter
        self._label = label
        self._value = parameter.value
        self._is_long = has_long_value(parameter.type, parameter.value)
        self._is_setting = False
        self._waiting: Any = None  # the next value to send, while the node has not answered yet
        self._showers: list[Callable[[Any], object]] = []
        row = ui.element("div").classes("zb-parameter")
        # The name is not part of a text for `row.props()`, because a quote in the name would end
        # the property.
        row.props["data-name"] = parameter.name
        with row:
            with ui.element("div").classes("zb-row"):
                ui.label(label).classes("zb-mono zb-parameter-name")
                ui.label(parameter.type.text).classes("zb-muted")
                if parameter.is_read_only:
                    ui.label("read-only").classes("zb-badge")
            about = " ".join(filter(None, (parameter.description, parameter.constraints)))
            ui.label(about).classes("zb-muted zb-about").set_visibility(bool(about))
            with ui.element("div").classes("zb-row"):
                self._build()
                if beside is not None:
                    self._add_beside(beside)
            self._refusal = ui.label().classes("zb-bad zb-refusal")
            self._refusal.set_visibility(False)

    def show(self, type_: Parameter.Type, value: Any) -> bool:
        """Show a new value. If it needs another kind of input, show nothing and return False."""
        if type_ != self._parameter.type or has_long_value(type_, value) != self._is_long:
            return False
        self._value = value
        for shower in self._showers:
            shower(value)
        return True

    def _build(self) -> None:
        parameter = self._parameter
        if parameter.is_read_only or self._section.page.read_only or self._is_long:
            label = ui.label().classes("zb-mono")
            self._showers.append(lambda value: label.set_text(self._text(value)))
            if self._is_long:
                ui.label("too long for the page: use zbot param get").classes("zb-muted")
        elif parameter.type is Parameter.Type.BOOL:
            self._add_switch()
        else:
            if parameter.range is not None:
                self._add_slider(parameter.range)
            self._add_text()
        self.show(parameter.type, parameter.value)

    def _add_switch(self) -> None:
        switch = ui.switch().props("dense")
        switch.props["aria-label"] = self._label
        switch.on("click", with_errors_shown(self._on_switch(switch)))
        self._showers.append(switch.set_value)

    def _on_switch(self, switch: ui.switch) -> Callable[..., Any]:
        async def flip(_event: object) -> None:
            await self._set(bool(switch.value))

        return flip

    def _add_slider(self, limits: Range) -> None:
        is_whole = self._parameter.type is Parameter.Type.INTEGER
        step = limits.step or (1 if is_whole else (limits.high - limits.low) / _STEPS)
        slider = ui.slider(min=limits.low, max=limits.high, step=step)
        slider.classes("zb-grow").props["aria-label"] = f"{self._label} slider"
        convert = round if is_whole else float

        # The value is that of the event: an older value may have moved the slider since then.
        async def slide(event: GenericEventArguments) -> None:
            await self._set(convert(event.args or 0.0))

        # This event comes only when the user moves the slider, not when this program moves it.
        slider.on(
            "update:model-value",
            with_errors_shown(slide),
            throttle=_DRAG_S,
            js_handler="(value) => emit(value)",
        )
        self._showers.append(slider.set_value)

    def _add_text(self) -> None:
        parameter = self._parameter
        box = _TextBox(self._commit)
        box.element.props["aria-label"] = self._label
        box.element.classes("zb-short-number" if parameter.range is not None else "zb-grow")
        if parameter.range is not None:
            ui.label(parameter.range.text).classes("zb-muted zb-range")
        self._showers.append(lambda value: box.show(self._text(value)))

    async def _commit(self, text: str) -> None:
        try:
            value = self._parameter.read(text)
        except FieldMisfitError as error:
            self._refuse(error.sentence)
            return
        await self._set(value)

    def _add_beside(self, text: Callable[[DescribedParameter, Any], str]) -> None:
        label = ui.label(text(self._parameter, self._value)).classes("zb-mono zb-beside")
        self._showers.append(lambda value: label.set_text(text(self._parameter, value)))

    def _text(self, value: Any) -> str:
        return show_value(self._parameter.type, value)

    async def _set(self, value: Any) -> None:
        if self._is_setting:
            self._waiting = value
            return
        self._is_setting = True
        try:
            await self._send(value)
            while self._waiting is not None:
                value, self._waiting = self._waiting, None
                await self._send(value)
        finally:
            # After an error, a value that waits is old: the next value must be the last one.
            self._is_setting, self._waiting = False, None

    async def _send(self, value: Any) -> None:
        parameter = self._parameter
        if not has_long_value(parameter.type, value):
            words = ("param", "set", self._node, parameter.name, self._text(value))
            self._section.page.show_command(command_line(*words))
        message = Parameter(parameter.name, parameter.type, value)
        try:
            refusal = await run_in_thread(set_value, self._section.system, self._node, message)
        except ZbotError:
            self._restore()
            raise
        if refusal:
            self._refuse(refusal)
        else:
            self._refusal.set_visibility(False)
            self.show(parameter.type, value)

    def _refuse(self, reason: str) -> None:
        """Show why a value was refused, and show the present value again."""
        self._refusal.set_text(reason)
        self._refusal.set_visibility(True)
        self._restore()

    def _restore(self) -> None:
        for shower in self._showers:
            shower(self._value)


class _TextBox:
    """Text input that shows a value, but not over a text that the user is typing.

    Args:
        commit: Called with the text when the user has pressed Enter or left the input.
    """

    def __init__(self, commit: Callable[[str], Awaitable[None]]) -> None:
        self.element = ui.input().props("dense outlined hide-bottom-space")
        self._shown = ""  # another text was typed by the user, and is not committed yet

        async def end(event: GenericEventArguments) -> None:
            self._leave()
            await commit(event.args)

        self.element.on("change", with_errors_shown(end), js_handler="(value) => emit(value)")
        self.element.on("blur", self._leave)

    def show(self, text: str) -> None:
        """Show a text, unless the user is typing another one."""
        is_typing = self.element.value != self._shown
        self._shown = text
        if not is_typing:
            self.element.set_value(text)

    def _leave(self) -> None:
        self._shown = self.element.value
