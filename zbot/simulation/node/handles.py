"""Handles with which a user moves robots and things in the 3D view: interactive markers."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Protocol

from zbot.libraries.interactive_markers import InteractiveMarkerServer, MenuHandler
from zbot.simulation.node.frames import WORLD_FRAME
from zbot.tf2.rigid import Rigid

from geometry_msgs.msg import Pose, Quaternion
from visualization_msgs.msg import (
    InteractiveMarker,
    InteractiveMarkerControl,
    InteractiveMarkerFeedback,
    Marker,
)

if TYPE_CHECKING:
    from zbot.node.node import Node
    from zbot.simulation.free_body import FreeBody
    from zbot.simulation.world import World

_MOST = 100
_FARTHEST_M = 10_000.0
#: A handle follows a body that has moved farther than this, in metres.
_MOVED_M = 0.01
_SCALE = 0.5
_BUTTON_HEIGHT_M = 0.25
#: The axis of the control is the vertical one.
_UPRIGHT = Quaternion(y=-math.sqrt(0.5), w=math.sqrt(0.5))


class HandledSimulator(Protocol):
    """The part of the simulator that handles use."""

    world: World

    def reset(self, *, time_too: bool) -> None:
        """Put all bodies back to where they started."""
        ...


class Handles:
    """Handles of the robots and the things of one simulator, with a menu.

    Args:
        node: The node with the topics.
        simulator: What moves the bodies.
    """

    def __init__(self, node: Node, simulator: HandledSimulator) -> None:
        self._simulator = simulator
        self._server = InteractiveMarkerServer(node, "/simulation/handles")
        self._menu = MenuHandler()
        self._menu.insert("Put everything back", callback=self._put_back)
        self._shown: dict[str, Rigid] = {}  # the poses of the handles
        self._held = ""

    def update(self) -> None:
        """Show a handle for each robot and thing, at the place where it is now."""
        world = self._simulator.world
        present = dict([*world.robots.items(), *world.things.items()][:_MOST])
        for name in self._shown.keys() - present.keys():
            del self._shown[name]
            self._server.erase(name)
        for name, body in present.items():
            if name not in self._shown:
                self._add(name, body)
            elif name != self._held and _is_elsewhere(body.pose, self._shown[name]):
                self._server.setPose(name, _message(body.pose))
                self._shown[name] = body.pose
        self._server.applyChanges()

    def _add(self, name: str, body: FreeBody) -> None:
        move = InteractiveMarkerControl(name="move", orientation=_UPRIGHT)
        move.interaction_mode = InteractiveMarkerControl.MOVE_ROTATE
        menu = InteractiveMarkerControl(name="menu", markers=[_button()])
        menu.interaction_mode = InteractiveMarkerControl.MENU
        marker = InteractiveMarker(name=name, description=name, scale=_SCALE, controls=[move, menu])
        marker.header.frame_id = WORLD_FRAME
        marker.pose = _message(body.pose)
        self._server.insert(marker, feedback_callback=self._take)
        self._menu.apply(self._server, name)
        self._shown[name] = body.pose

    def _take(self, feedback: Any) -> None:
        """Move a body as the user moves its handle. It stays upright, at its height."""
        if feedback.event_type == InteractiveMarkerFeedback.MOUSE_DOWN:
            self._held = feedback.marker_name
        elif feedback.event_type == InteractiveMarkerFeedback.MOUSE_UP:
            self._held = ""
        body = self._simulator.world.entity(feedback.marker_name)
        place, turned = feedback.pose.position, feedback.pose.orientation
        values = (place.x, place.y, turned.z, turned.w)
        is_move = feedback.event_type == InteractiveMarkerFeedback.POSE_UPDATE
        if not is_move or body is None or not all(map(math.isfinite, values)):
            return
        length = math.hypot(turned.z, turned.w)
        if max(abs(place.x), abs(place.y)) > _FARTHEST_M or length < 0.01:
            return
        height = body.pose.translation[2]
        rotation = (0.0, 0.0, turned.z / length, turned.w / length)
        body.pose = Rigid((place.x, place.y, height), rotation)
        body.stop()
        self._simulator.world.refresh()
        self._shown[feedback.marker_name] = body.pose

    def _put_back(self, _feedback: Any) -> None:
        self._simulator.reset(time_too=False)


def _button() -> Any:
    """Return the ball above a body, which a user clicks for the menu."""
    ball = Marker(type=Marker.SPHERE)
    ball.pose.position.z = _BUTTON_HEIGHT_M
    ball.scale.x = ball.scale.y = ball.scale.z = 0.06
    ball.color.r, ball.color.g, ball.color.b, ball.color.a = 0.95, 0.65, 0.1, 1.0
    return ball


def _is_elsewhere(pose: Rigid, before: Rigid) -> bool:
    has_turned = abs(abs(sum(map(float.__mul__, pose.rotation, before.rotation))) - 1) > 1e-4
    return has_turned or math.dist(pose.translation, before.translation) > _MOVED_M


def _message(pose: Rigid) -> Any:
    message = Pose()
    at, turned = message.position, message.orientation
    at.x, at.y, at.z = pose.translation
    turned.x, turned.y, turned.z, turned.w = pose.rotation
    return message
