"""Panel with a slider for each joint of a robot, as the window of joint_state_publisher_gui."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from nicegui import ui

from zbot.interfaces import get_service
from zbot.libraries.robot_description.joint_sliders import (
    ANGLE,
    CENTER,
    EMPTY_TYPE,
    PREFIX,
    RANDOMIZE,
)
from zbot.web.page.command_line import command_line
from zbot.web.page.panel import Page, Panel
from zbot.web.page.service_call import call, with_errors_shown
from zbot.web.panels.joints.other_joints import OtherJoints
from zbot.web.panels.joints.slider_nodes import slider_nodes, states_topic
from zbot.web.panels.parameters.node_parameters import NodeParameters

if TYPE_CHECKING:
    from zbot.web.page.panel import Section
    from zbot.web.panels.parameters.described_parameter import DescribedParameter

_HZ = 10.0
_RUN = "zbot run joint_state_publisher_gui joint_state_publisher_gui"
_NOBODY = f"No node has sliders for joints. Start one:  {_RUN}"
_NO_JOINTS = (
    "This robot has no joints that move, or its description has not arrived: a node must publish "
    "it on robot_description, e.g. robot_state_publisher."
)


class JointsPanel:
    """Panel of one browser.

    Args:
        page: The page.
    """

    def __init__(self, page: Page) -> None:
        self._page = page
        self._revision = -1
        self._node = ""
        self._section: Section | None = None
        page.show_command(_RUN)
        with page.toolbar:
            self._chooser = ui.select([], on_change=self._on_choice)
            self._chooser.props('dense outlined options-dense aria-label="Robot"')
            with ui.element("div").classes("zb-row") as self._buttons:
                self._button("Center", CENTER, "Move each joint to its position at the start")
                self._button("Randomize", RANDOMIZE, "Move each joint to any position")
        self._said = ui.label(_NOBODY).classes("zb-empty").props("role=status")
        self._place = ui.element("div").classes("zb-col zb-joints")
        page.live(self._match, _HZ)

    def _button(self, text: str, service: str, hint: str) -> None:
        async def press() -> None:
            name = f"{self._node}/{service}"
            self._page.show_command(command_line("service", "call", name, EMPTY_TYPE))
            request = get_service(EMPTY_TYPE).Request()  # type: ignore[attr-defined] # it has one
            await call(self._page.system, name, EMPTY_TYPE, request)

        button = ui.button(text, on_click=with_errors_shown(press), color=None)
        button.props("outline dense no-wrap").classes("zb-button").tooltip(hint)

    def _match(self) -> None:
        """Show the sliders of the wanted node, or of the first one."""
        if self._revision == self._page.system.revision:
            return
        self._revision = self._page.system.revision
        found = slider_nodes(self._page.system.snapshot())
        wanted = self._page.query.get("node", found[0] if found else "")
        node = wanted if wanted in found else ""
        if node != self._node:
            self._show(node)
        self._said.set_text(f"{wanted} does not run." if wanted else _NOBODY)
        self._said.set_visibility(not node)
        self._buttons.set_visibility(bool(node) and not self._page.read_only)
        self._chooser.set_options(found, value=node or None)
        self._chooser.set_visibility(len(found) > bool(node))

    def _on_choice(self) -> None:
        node = str(self._chooser.value or "")
        if node and node != self._node:
            self._page.set_query(node=node)
            self._revision = -1
            self._match()  # now: the buttons are for the robot that the user sees chosen

    def _show(self, node: str) -> None:
        if self._section is not None:
            self._section.close()
        self._place.clear()
        self._node, self._section = node, None
        if not node:
            self._page.show_command(_RUN)
            return
        self._section = self._page.section()
        with self._place:
            self._add(self._section, node)

    def _add(self, section: Section, node: str) -> None:
        with ui.element("div").classes("zb-card"):
            sliders = NodeParameters(
                section, node, prefix=PREFIX, beside=_degrees, empty=_NO_JOINTS
            )
        topic = states_topic(self._page.system.snapshot(), node)
        if topic is not None:
            OtherJoints(section, section.watch(topic), lambda: sliders.names)


def _degrees(parameter: DescribedParameter, value: Any) -> str:
    """Return an angle in degrees, which stands beside the angle in rad."""
    is_angle = parameter.description == ANGLE and isinstance(value, float)
    return f"{math.degrees(value):.1f}°" if is_angle and math.isfinite(value) else ""


def _build(page: Page) -> None:
    JointsPanel(page)


PANEL = Panel("/joints", "Joints", "precision_manufacturing", _build)
