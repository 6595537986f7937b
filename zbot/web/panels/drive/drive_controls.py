"""Sticks, buttons and limits on the screen. `drive.js` reads them and sends the values."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from nicegui import ui

from zbot.web.panels.drive.drive_message import BUTTONS

if TYPE_CHECKING:
    from zbot.web.page.panel import Page, Section
    from zbot.web.panels.drive.drive_control import DriveControl
    from zbot.web.panels.drive.drive_message import SpeedLimits

_HZ = 10.0
_VELOCITY_HINT = (
    "Hold the stick, or the keys W A S D or the arrows (Q and E: sideways). With a gamepad, hold a "
    "shoulder button and move the left stick. The robot stops when you let go."
)
_GAMEPAD_HINT = (
    "Buttons stay pressed until the next click. The sticks and buttons are released when you leave "
    "this page."
)


class LimitInputs:
    """Inputs of the speed limits, which the browser keeps.

    Args:
        page: The page.
        limits: The limits, which the inputs change.

    Attributes:
        row: The element with all inputs.
        is_omni: The switch for robots that move sideways.
    """

    def __init__(self, page: Page, limits: SpeedLimits) -> None:
        self._page, self._limits = page, limits
        ui.on("zbot_drive_kept", lambda event: self.restore(event.args))
        with ui.element("div").classes("zb-row zb-inputs") as self.row:
            self._linear = _number("speed", limits.linear_m_s, "m/s", self._change)
            self._angular = _number("turn", limits.angular_rad_s, "rad/s", self._change)
            self.is_omni = ui.switch("sideways", on_change=self._change).props("dense")
            self.is_omni.tooltip("The robot can move sideways (linear.y)")

    def restore(self, kept: Any) -> None:
        """Show the values that the browser kept."""
        if isinstance(kept, list) and len(kept) == 3:
            linear_m_s, angular_rad_s, is_omni = kept
            self._limits.set(linear_m_s, angular_rad_s)
            angular_rad_s = self._limits.angular_rad_s  # a change of an input sets both limits
            self._linear.set_value(self._limits.linear_m_s)
            self._angular.set_value(angular_rad_s)
            self.is_omni.set_value(is_omni is True)

    def _change(self) -> None:
        self._limits.set(self._linear.value, self._angular.value)
        kept = self._limits.linear_m_s, self._limits.angular_rad_s, self.is_omni.value
        self._page.call("zbotDrive.keep", *kept)


def _number(label: str, value: float, unit: str, on_change: Any) -> ui.number:
    number = ui.number(value=value, prefix=label, suffix=unit, min=0, step=0.1, on_change=on_change)
    number.props(f'dense outlined aria-label="Limit of the {label}, {unit}"')
    return number.classes("zb-short-number")


def add_velocity_controls(section: Section, control: DriveControl, inputs: LimitInputs) -> None:
    """Add the sticks and the velocity to the current element.

    Args:
        section: The section of the page.
        control: The control, whose velocity is shown.
        inputs: The inputs of the limits. They say whether there is a second stick.
    """
    with ui.element("div").classes("zb-col zb-drive-controls").props("data-kind=velocity"):
        with ui.element("div").classes("zb-row zb-sticks"):
            _stick("move", "Stick")
            turn = _stick("turn", "Turn")
        shown = ui.label().classes("zb-mono zb-drive-velocity")
        _said()
        ui.label(_VELOCITY_HINT).classes("zb-muted zb-hint")
    turn.bind_visibility_from(inputs.is_omni, "value")

    def update() -> None:
        ahead, left, turn_rad_s = control.velocity
        sideways = f"   left {left:+.2f} m/s" if inputs.is_omni.value else ""
        shown.set_text(f"ahead {ahead:+.2f} m/s{sideways}   turn {turn_rad_s:+.2f} rad/s")

    section.live(update, _HZ)


def add_gamepad_controls() -> None:
    """Add two sticks and the buttons of a gamepad to the current element."""
    with ui.element("div").classes("zb-col zb-drive-controls").props("data-kind=gamepad"):
        with ui.element("div").classes("zb-row zb-sticks"):
            _stick("left", "Left stick")
            _stick("right", "Right stick")
        with ui.element("div").classes("zb-row"):
            for number in range(BUTTONS):
                button = ui.button(str(number), color=None).props("outline dense")
                button.props(f"data-button={number} aria-pressed=false").classes("zb-key")
        _said()
        ui.label(_GAMEPAD_HINT).classes("zb-muted zb-hint")


def _stick(name: str, label: str) -> ui.element:
    stick = ui.element("div").classes("zb-stick").props(f'data-stick={name} role="group"')
    with stick.props(f'aria-label="{label}"'):
        ui.element("div").classes("zb-knob")
    return stick


def _said() -> None:
    """Add the place where the script says why the robot was stopped."""
    ui.element("div").classes("zb-warn zb-drive-said").props('role="status"')
