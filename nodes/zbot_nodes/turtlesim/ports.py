"""Entities of one turtle: its topics, services and action."""

from __future__ import annotations

from typing import Any

import zbot
from zbot.action import ActionServer, CancelResponse
from zbot_nodes.turtlesim.world import Rotation, RotationState, Turtle, TurtleWorld

from geometry_msgs.msg import Twist
from turtlesim.action import RotateAbsolute
from turtlesim.msg import Color, Pose
from turtlesim.srv import SetPen, TeleportAbsolute, TeleportRelative

DEPTH = 7


class TurtlePorts:
    """The topics, services and the action of one turtle.

    Args:
        node: The node that has the entities, and the parameter `holonomic`.
        world: The world of the turtle.
        turtle: The turtle.
    """

    def __init__(self, node: zbot.Node, world: TurtleWorld, turtle: Turtle) -> None:
        self.node = node
        self.world = world
        self.turtle = turtle
        name = turtle.name
        self.pose = node.create_publisher(Pose, f"{name}/pose", DEPTH)
        self.color = node.create_publisher(Color, f"{name}/color_sensor", DEPTH)
        self.cmd_vel = node.create_subscription(Twist, f"{name}/cmd_vel", self.drive, DEPTH)
        self.services = [
            node.create_service(SetPen, f"{name}/set_pen", self.set_pen),
            node.create_service(TeleportAbsolute, f"{name}/teleport_absolute", self.teleport_to),
            node.create_service(TeleportRelative, f"{name}/teleport_relative", self.teleport_by),
        ]
        self.rotate_absolute: ActionServer[Any, Any, Any] = ActionServer(
            node,
            RotateAbsolute,
            f"{name}/rotate_absolute",
            self.rotate,
            cancel_callback=lambda _: CancelResponse.ACCEPT,
        )

    def drive(self, command: Twist) -> None:
        """Set the turtle's velocity. The turtle moves sideways only if `holonomic` is true."""
        is_holonomic = self.node.get_parameter("holonomic").value
        sideways = command.linear.y if is_holonomic else None
        self.world.command(self.turtle.name, command.linear.x, command.angular.z, sideways)

    def set_pen(self, request: SetPen.Request, response: SetPen.Response) -> SetPen.Response:
        """Change the turtle's pen."""
        self.turtle.set_pen(request.r, request.g, request.b, request.width, request.off)
        return response

    def teleport_to(
        self, request: TeleportAbsolute.Request, response: TeleportAbsolute.Response
    ) -> TeleportAbsolute.Response:
        """Jump to a position."""
        self.turtle.teleport_to(request.x, request.y, request.theta)
        return response

    def teleport_by(
        self, request: TeleportRelative.Request, response: TeleportRelative.Response
    ) -> TeleportRelative.Response:
        """Turn, and jump ahead."""
        self.turtle.teleport_by(request.linear, request.angular)
        return response

    async def rotate(self, goal_handle: Any) -> RotateAbsolute.Result:
        """Turn to a heading, one step at each tick."""
        ended: zbot.Future[RotateAbsolute.Result] = zbot.Future()
        endings = {
            RotationState.SUCCEEDED: goal_handle.succeed,
            RotationState.CANCELED: goal_handle.canceled,
            RotationState.ABORTED: goal_handle.abort,
        }

        def end(state: RotationState, delta: float) -> None:
            endings[state]()
            ended.set_result(RotateAbsolute.Result(delta=delta))

        def send_feedback(remaining: float) -> None:
            goal_handle.publish_feedback(RotateAbsolute.Feedback(remaining=remaining))

        theta = goal_handle.request.theta
        rotation = Rotation(
            theta, send_feedback, end, lambda: bool(goal_handle.is_cancel_requested)
        )
        self.world.rotate(self.turtle.name, rotation)
        result = await ended
        return result if result is not None else RotateAbsolute.Result()

    def publish(self) -> None:
        """Publish the turtle's pose and the colour below it."""
        turtle = self.turtle
        self.pose.publish(
            Pose(
                x=turtle.x,
                y=turtle.y_up,
                theta=turtle.heading,
                linear_velocity=turtle.speed,
                angular_velocity=turtle.turn,
            )
        )
        r, g, b = self.world.colour_under(turtle)
        self.color.publish(Color(r=r, g=g, b=b))

    def destroy(self) -> None:
        """Destroy the entities."""
        self.rotate_absolute.destroy()
        for service in self.services:
            self.node.destroy_service(service)
        self.node.destroy_subscription(self.cmd_vel)
        self.node.destroy_publisher(self.color)
        self.node.destroy_publisher(self.pose)
