"""Panel that drives a robot, and stops it when the user lets go or the browser is silent."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from nicegui import ui

from zbot.errors import ZbotError
from zbot.web.page.command_line import command_line
from zbot.web.page.panel import Page, Panel
from zbot.web.page.service_call import show_error
from zbot.web.panels.drive.drive_control import DriveControl
from zbot.web.panels.drive.drive_controls import (
    LimitInputs,
    add_gamepad_controls,
    add_velocity_controls,
)
from zbot.web.panels.drive.drive_message import SpeedLimits
from zbot.web.panels.drive.drive_picture import DrivePicture
from zbot.web.panels.drive.drive_target import TYPES, DriveTarget, drive_targets

if TYPE_CHECKING:
    from zbot.web.page.panel import Section

_HZ = 10.0
_NO_ROBOT = (
    "No robot listens: no node subscribes to a topic of type geometry_msgs/msg/Twist or "
    "TwistStamped. Start one:  zbot run robot_base"
)
_READ_ONLY = "This page is read-only: it cannot drive."


class DrivePanel:
    """Panel of one browser.

    Args:
        page: The page.
    """

    def __init__(self, page: Page) -> None:
        self._page = page
        self._limits = SpeedLimits()
        self._revision = -1
        self._targets: dict[str, DriveTarget] = {}
        self._target: DriveTarget | None = None
        self._section: Section | None = None
        self._control: DriveControl | None = None
        page.show_command(command_line("topic", "list", "-t"))
        with page.toolbar:
            self._chooser = ui.select([], on_change=self._on_choice)
            self._chooser.props('dense outlined options-dense aria-label="Topic"')
        with ui.element("div").classes("zb-drive"):
            DrivePicture(page)
            with ui.element("div").classes("zb-card zb-col"):
                self._said = ui.label(_READ_ONLY if page.read_only else _NO_ROBOT)
                self._said.classes("zb-muted")
                self._place = ui.element("div").classes("zb-col")
                self._inputs = LimitInputs(page, self._limits)
        self._inputs.row.set_visibility(False)
        self._chooser.set_visibility(False)
        if page.read_only:
            return
        ui.on("zbot_drive", self._hear)
        ui.context.client.on_disconnect(self._stop)
        page.live(self._match, _HZ)

    def _hear(self, event: Any) -> None:
        if self._control is not None:
            self._control.hear(event.args)

    def _stop(self) -> None:
        if self._control is not None:
            self._control.stop()

    def _match(self) -> None:
        """Show the targets of the graph. A target that the page drives stays the same."""
        if self._revision == self._page.system.revision:
            return
        self._revision = self._page.system.revision
        found = drive_targets(self._page.system.snapshot())
        if self._target is None:
            target = self._first(found)
            if target is not None:
                self._drive(target)
        known = {*found, *([self._target] if self._target else [])}
        self._targets = {target.label: target for target in sorted(known, key=_order_in(found))}
        self._chooser.set_options(list(self._targets))
        self._chooser.set_value(self._target.label if self._target else None)
        self._chooser.set_visibility(len(self._targets) > (self._target is not None))
        self._say(found)

    def _first(self, found: list[DriveTarget]) -> DriveTarget | None:
        """Return the target of the address, or the first target."""
        topic, type_name = self._page.query.get("topic"), self._page.query.get("type")
        if topic is None:
            return found[0] if found else None
        if type_name in TYPES:
            return DriveTarget(topic, type_name)
        return next((target for target in found if target.topic == topic), None)

    def _say(self, found: list[DriveTarget]) -> None:
        if self._target is None:
            topic = self._page.query.get("topic")
            self._said.set_text(_NO_ROBOT if topic is None else _nobody(topic))
        elif self._target not in found:
            self._said.set_text(_nobody(self._target.topic))
        self._said.set_visibility(self._target not in found)

    def _on_choice(self) -> None:
        target = self._targets.get(str(self._chooser.value))
        if target is not None and target != self._target:
            self._drive(target)
            self._revision = -1

    def _drive(self, target: DriveTarget) -> None:
        if self._section is not None:
            self._section.close()
        self._place.clear()
        self._section, self._target, self._control = self._page.section(), target, None
        self._inputs.row.set_visibility(not target.is_gamepad)
        self._page.set_query(topic=target.topic, type=target.type_name)
        self._page.show_command(command_line("topic", "echo", target.topic))
        try:
            self._control = DriveControl(self._section, target, self._limits)
        except ZbotError as error:
            show_error(error)
            return
        with self._place:
            if target.is_gamepad:
                add_gamepad_controls()
            else:
                add_velocity_controls(self._section, self._control, self._inputs)
        self._page.call("zbotDrive.start")


def _nobody(topic: str) -> str:
    return f"No node subscribes to {topic} now."


def _order_in(found: list[DriveTarget]) -> Any:
    return lambda target: found.index(target) if target in found else len(found)


def _build(page: Page) -> None:
    DrivePanel(page)


PANEL = Panel("/drive", "Drive", "sports_esports", _build)
