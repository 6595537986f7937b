"""Tools that publish or measure. Each is used with one or two clicks on the floor."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, ClassVar, NamedTuple, Protocol

import numpy as np

from zbot.tf2.rigid import Rigid
from zbot.view import solid
from zbot.view.colors import same
from zbot.view.displays.pose import pose_shapes
from zbot.view.shape import Item, Label, Lines, Mesh

from geometry_msgs.msg import PointStamped, PoseStamped, PoseWithCovarianceStamped

if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from zbot.tf2.rigid import Vector
    from zbot.view.arrangement.arrangement import PointerTopics
    from zbot.view.shape import Color, Shape

_GREEN, _PINK, _YELLOW = (25, 190, 60), (220, 60, 180), (200, 160, 0)
_MARK_M = 0.12
_ARROW_M = 0.8


class Outlet(Protocol):
    """What sends the messages of tools."""

    def open(self, topic: str, type_name: str) -> None:
        """Create a publisher."""

    def send(self, topic: str, type_name: str, message: Any) -> int:
        """Publish a message. Return the number of nodes that subscribe to the topic."""
        ...

    def navigate(self, pose: Any, topic: str) -> list[str]:
        """Send a goal to action servers for navigation, and return their names."""
        ...

    def ask(
        self, service: str, type_name: str, request: Any, answer: Callable[[Any], object]
    ) -> None:
        """Call a service that changes nothing. Give its response to a function, in any thread."""


class Surroundings(NamedTuple):
    """What a tool needs to make messages."""

    fixed_frame: str
    now_ns: int
    topics: PointerTopics
    outlet: Outlet


class Tool:
    """Tool with clicks on the floor, which is the plane of x and y of the fixed frame.

    Attributes:
        name: The name of the tool in rviz.
        hint: What to do first.
        hint_after_one: What to do after the first of two clicks.
        items: What the tool shows in the scene.
    """

    name: ClassVar[str]
    hint: ClassVar[str] = "Click on the floor."
    hint_after_one: ClassVar[str] = ""
    color: ClassVar[Color] = _YELLOW

    def __init__(self) -> None:
        self.items: dict[str, Item] = {}
        self._first: Vector | None = None

    def begin(self, around: Surroundings) -> None:
        """Prepare, before the first click."""

    def click(self, place: Vector, around: Surroundings) -> str:
        """Use the tool at a place. Return a sentence about what has happened, or what to do."""
        if not self.hint_after_one:
            self.items = {"mark": Item("", 0, (mark(place, self.color),))}
            return self.use(place, place, around)
        if self._first is None:
            self._first = place
            self.items = {"mark": Item("", 0, (mark(place, self.color),))}
            return self.hint_after_one
        first, self._first = self._first, None
        return self.use(first, place, around)

    def use(self, first: Vector, second: Vector, around: Surroundings) -> str:
        """Do the work of the tool. Return a sentence about it."""
        raise NotImplementedError


class PoseTool(Tool):
    """Publish the pose at one place that looks towards another place.

    Attributes:
        type_name: The type of its messages.
    """

    type_name: ClassVar[str]

    def begin(self, around: Surroundings) -> None:
        """Create the publisher."""
        around.outlet.open(self.topic(around.topics), self.type_name)

    def use(self, first: Vector, second: Vector, around: Surroundings) -> str:
        """Publish the pose, and show it as an arrow."""
        pose, yaw = flat_pose(first, second)
        self.items = {"arrow": Item("", 0, tuple(arrow(pose, self.color)))}
        message, topic = self.message(pose, around), self.topic(around.topics)
        stamp(message, around)
        count = around.outlet.send(topic, self.type_name, message)
        return f"{where(first, yaw)} {sent(topic, count)}{self.follow_up(message, around)}"

    def topic(self, topics: PointerTopics) -> str:
        """Return the topic of the tool."""
        raise NotImplementedError

    def message(self, pose: Rigid, around: Surroundings) -> Any:
        """Return the message without its header."""
        raise NotImplementedError

    def follow_up(self, message: Any, around: Surroundings) -> str:  # noqa: ARG002 - a class may need it
        """Do what comes after the message. Return a text about it, or an empty one."""
        return ""


class InitialPose(PoseTool):
    """Tell a localization where the robot is, with the variances of rviz."""

    name = "2D Pose Estimate"
    hint = "Click where the robot is."
    hint_after_one = "Click a place in front of the robot."
    color = _GREEN
    type_name = "geometry_msgs/msg/PoseWithCovarianceStamped"

    def topic(self, topics: PointerTopics) -> str:
        """Return the topic of the tool."""
        return topics.initial_pose

    def message(self, pose: Rigid, around: Surroundings) -> Any:
        """Return the message without its header."""
        message = PoseWithCovarianceStamped()
        fill(message.pose.pose, pose)
        covariance = [0.0] * 36
        covariance[0] = covariance[7] = around.topics.variance_xy
        covariance[35] = around.topics.variance_yaw
        message.pose.covariance = covariance
        return message


class Goal(PoseTool):
    """Send the robot to a pose: on a topic, and to a navigation that does not listen to it."""

    name = "2D Goal Pose"
    hint = "Click where the robot must go."
    hint_after_one = "Click a place in front of the robot at its goal."
    color = _PINK
    type_name = "geometry_msgs/msg/PoseStamped"

    def topic(self, topics: PointerTopics) -> str:
        """Return the topic of the tool."""
        return topics.goal

    def message(self, pose: Rigid, around: Surroundings) -> Any:  # noqa: ARG002 - the base class has it
        """Return the message without its header."""
        message = PoseStamped()
        fill(message.pose, pose)
        return message

    def follow_up(self, message: Any, around: Surroundings) -> str:
        """Send the goal to navigations."""
        actions = around.outlet.navigate(message, self.topic(around.topics))
        return "".join(f" Sent as a goal to {name}." for name in actions)


class PublishPoint(Tool):
    """Publish the place of a click."""

    name = "Publish Point"
    _TYPE = "geometry_msgs/msg/PointStamped"

    def begin(self, around: Surroundings) -> None:
        """Create the publisher."""
        around.outlet.open(around.topics.point, self._TYPE)

    def use(self, first: Vector, second: Vector, around: Surroundings) -> str:  # noqa: ARG002 - one click
        """Publish the point."""
        message = PointStamped()
        stamp(message, around)
        message.point.x, message.point.y, message.point.z = first
        topic = around.topics.point
        count = around.outlet.send(topic, self._TYPE, message)
        return f"x = {first[0]:.2f} m, y = {first[1]:.2f} m. {sent(topic, count)}"


class Measure(Tool):
    """Measure the distance between two places."""

    name = "Measure"
    hint = "Click on the floor where the distance begins."
    hint_after_one = "Click where the distance ends."

    def use(self, first: Vector, second: Vector, around: Surroundings) -> str:  # noqa: ARG002 - it sends nothing
        """Show the distance."""
        text = f"{math.dist(first, second):.2f} m"
        ends = np.array([[first, second]], np.float32)
        x, y, z = ends[0].mean(axis=0)
        shapes = (
            mark(first, self.color),
            mark(second, self.color),
            Lines(ends, same(self.color, 1, 2), 3.0),
            Label(text, (float(x), float(y), float(z))),
        )
        self.items = {"line": Item("", 0, shapes)}
        return f"The distance is {text}."


TOOLS: tuple[type[Tool], ...] = (InitialPose, Goal, PublishPoint, Measure)


def flat_pose(place: Vector, towards: Vector) -> tuple[Rigid, float]:
    """Return the pose at a place that looks towards another place, and its yaw in rad."""
    yaw = math.atan2(towards[1] - place[1], towards[0] - place[0])
    return Rigid(place, (0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2))), yaw


def stamp(message: Any, around: Surroundings) -> None:
    """Set the header of a message."""
    message.header.frame_id = around.fixed_frame
    seconds, rest = divmod(around.now_ns, 10**9)
    message.header.stamp.sec, message.header.stamp.nanosec = seconds, rest


def fill(message: Any, pose: Rigid) -> None:
    """Set the fields of a `geometry_msgs/Pose`."""
    message.position.x, message.position.y, message.position.z = pose.translation
    turn = message.orientation
    turn.x, turn.y, turn.z, turn.w = pose.rotation


def where(place: Vector, yaw: float) -> str:
    """Return a sentence with a place and an angle."""
    return f"x = {place[0]:.2f} m, y = {place[1]:.2f} m, angle = {math.degrees(yaw):.0f}°."


def sent(topic: str, count: int) -> str:
    """Return a sentence about a published message."""
    return f"Published on {topic}." if count else f"Published on {topic}, but nobody subscribes."


def mark(place: Vector, color: Color) -> Mesh:
    """Return a small sphere."""
    vertices, faces = solid.sphere()
    return Mesh(vertices * _MARK_M, faces, color, pose=Rigid(place))


def arrow(pose: Rigid, color: Color) -> list[Shape]:
    """Return an arrow at a pose."""
    return pose_shapes([pose], "arrow", _ARROW_M, color)
