"""Form for one message type, shown in the page. It checks inputs while the user types."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

from nicegui import ui

from zbot.web.forms.form import Form, Group, Input, InputKind

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.web.forms.form import Entry, Member

_HINTS = {
    InputKind.TIME: "seconds, or now",
    InputKind.DURATION: "seconds",
    InputKind.LIST: "[1, 2, 3]",
}


class FormView:
    """Inputs for messages of one type. The constructor adds them to the current element.

    Args:
        message_type: A message class, the `Request` of a service, or the `Goal` of an action.
        on_change: Called when the user has changed an input.
    """

    def __init__(
        self, message_type: type[Any], on_change: Callable[[], object] | None = None
    ) -> None:
        self.form = Form(message_type)
        self._on_change = on_change
        self._entries: dict[str, Entry] = {}
        self._inputs: dict[str, Any] = {}
        with ui.element("div").classes("zb-form"):
            for member in self.form.members:
                self._add(member, 0)
            if not self.form.members:
                ui.label("This type has no fields.").classes("zb-muted")

    @property
    def problems(self) -> dict[str, str]:
        """A sentence about each wrong input, by path."""
        return self.form.problems(self._entries)

    def message(self) -> Any:
        """Return the message that contains the values of the inputs.

        Raises:
            FieldMisfitError: An entry does not fit its field.
        """
        return self.form.message(self._entries)

    def maker(self) -> Callable[[], Any]:
        """Return a quick function that returns a message with the present values of the inputs.

        Any thread may call the returned function. See `Form.maker`.

        Raises:
            FieldMisfitError: An entry does not fit its field.
        """
        return self.form.maker(self._entries)

    def yaml(self) -> str:
        """Return the message as YAML for a command line: `{linear: {x: 2.0}}`.

        Raises:
            FieldMisfitError: An entry does not fit its field.
        """
        return self.form.yaml(self._entries)

    def _add(self, member: Member, depth: int) -> None:
        indent = f"padding-left: {depth * 16}px"
        if isinstance(member, Group):
            with ui.element("div").classes("zb-form-group").style(indent):
                ui.label(member.name).classes("zb-mono")
                ui.label(member.type_name).classes("zb-muted")
            for inner in member.members:
                self._add(inner, depth + 1)
            return
        with ui.element("div").classes("zb-form-row"):
            label = ui.label(member.name).classes("zb-mono zb-form-name").style(indent)
            label.tooltip(str(member.type))
            self._inputs[member.path] = self._input(member)

    def _input(self, input_: Input) -> Any:
        changed = partial(self._changed, input_.path)
        if input_.kind is InputKind.BOOL:
            return ui.checkbox(value=input_.default == "true", on_change=changed).props("dense")
        made = ui.input(
            value=input_.default,
            placeholder=_HINTS.get(input_.kind, ""),
            on_change=changed,
            validation=partial(self.form.problem, input_),
        )
        made.props("dense outlined hide-bottom-space")
        made.props["aria-label"] = input_.path
        if input_.kind in {InputKind.INTEGER, InputKind.NUMBER}:
            made.props("inputmode=decimal")
        return made.classes("zb-form-input")

    def _changed(self, path: str, event: Any) -> None:
        self._entries[path] = event.value
        if self._on_change is not None:
            self._on_change()
