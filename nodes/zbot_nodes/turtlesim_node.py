"""Simulate turtles that draw.

Run:        zbot run turtlesim turtlesim_node
Drive:      zbot run turtlesim turtle_teleop_key
Subscribes: /turtle1/cmd_vel (geometry_msgs/msg/Twist), and so on for every turtle
Publishes:  /turtle1/pose (turtlesim/msg/Pose), /turtle1/color_sensor (turtlesim/msg/Color)
Serves:     /spawn /kill /clear /reset, /turtle1/set_pen, /turtle1/teleport_absolute,
            /turtle1/teleport_relative, and the action /turtle1/rotate_absolute
Parameters: background_r, background_g, background_b (0 to 255), holonomic (bool)
"""

from __future__ import annotations

from typing import Any

import zbot
from zbot.action import ActionServer, CancelResponse
from zbot_nodes.turtlesim.world import TICK_S, Rotation, RotationState, Turtle, TurtleWorld

from geometry_msgs.msg import Twist
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor
from std_srvs.srv import Empty
from turtlesim.action import RotateAbsolute
from turtlesim.msg import Color, Pose
from turtlesim.srv import Kill, SetPen, Spawn, TeleportAbsolute, TeleportRelative

_DEPTH = 7
_BACKGROUND = {"r": ("Red", 69), "g": ("Green", 86), "b": ("Blue", 255)}


class TurtlePorts:
    """The topics, services and the action of one turtle."""

    def __init__(self, node: TurtlesimNode, turtle: Turtle) -> None:
        self.node = node
        self.turtle = turtle
        name = turtle.name
        self.pose = node.create_publisher(Pose, f"{name}/pose", _DEPTH)
        self.color = node.create_publisher(Color, f"{name}/color_sensor", _DEPTH)
        self.cmd_vel = node.create_subscription(Twist, f"{name}/cmd_vel", self.drive, _DEPTH)
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
        """Take a velocity; sideways only if turtles are holonomic."""
        is_holonomic = self.node.get_parameter("holonomic").value
        sideways = command.linear.y if is_holonomic else None
        self.node.world.command(self.turtle.name, command.linear.x, command.angular.z, sideways)

    def set_pen(self, request: SetPen.Request, response: SetPen.Response) -> SetPen.Response:
        """Change what the turtle draws with."""
        self.turtle.set_pen(request.r, request.g, request.b, request.width, request.off)
        return response

    def teleport_to(
        self, request: TeleportAbsolute.Request, response: TeleportAbsolute.Response
    ) -> TeleportAbsolute.Response:
        """Jump to a place."""
        self.turtle.teleport_to(request.x, request.y, request.theta)
        return response

    def teleport_by(
        self, request: TeleportRelative.Request, response: TeleportRelative.Response
    ) -> TeleportRelative.Response:
        """Turn, and jump ahead."""
        self.turtle.teleport_by(request.linear, request.angular)
        return response

    async def rotate(self, goal_handle: Any) -> RotateAbsolute.Result:
        """Turn to a heading, tick by tick."""
        ended: zbot.Future[RotateAbsolute.Result] = zbot.Future()
        endings = {
            RotationState.SUCCEEDED: goal_handle.succeed,
            RotationState.CANCELED: goal_handle.canceled,
            RotationState.ABORTED: goal_handle.abort,
        }

        def end(state: RotationState, delta: float) -> None:
            endings[state]()
            ended.set_result(RotateAbsolute.Result(delta=delta))

        def tell(remaining: float) -> None:
            goal_handle.publish_feedback(RotateAbsolute.Feedback(remaining=remaining))

        theta = goal_handle.request.theta
        rotation = Rotation(theta, tell, end, lambda: bool(goal_handle.is_cancel_requested))
        self.node.world.rotate(self.turtle.name, rotation)
        result = await ended
        return result if result is not None else RotateAbsolute.Result()

    def publish(self) -> None:
        """Tell where the turtle is and what colour is below it."""
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
        r, g, b = self.node.world.colour_under(turtle)
        self.color.publish(Color(r=r, g=g, b=b))

    def destroy(self) -> None:
        """Take everything back."""
        self.rotate_absolute.destroy()
        for service in self.services:
            self.node.destroy_service(service)
        self.node.destroy_subscription(self.cmd_vel)
        self.node.destroy_publisher(self.color)
        self.node.destroy_publisher(self.pose)


class TurtlesimNode(zbot.Node):
    """Keeps a world of turtles, and a place in the graph for each."""

    def __init__(self) -> None:
        super().__init__("turtlesim")
        name = self.get_fully_qualified_name()
        self.get_logger().info(f"Starting turtlesim with node name {name}")
        self.declare_settings()
        self.ports: dict[str, TurtlePorts] = {}
        self.world = TurtleWorld(self.log)
        self.match_ports()
        self.create_service(Spawn, "spawn", self.spawn)
        self.create_service(Kill, "kill", self.kill)
        self.create_service(Empty, "clear", self.clear)
        self.create_service(Empty, "reset", self.reset)
        self.create_timer(TICK_S, self.tick)

    def declare_settings(self) -> None:
        """Declare the colour of the background, and whether turtles can move sideways."""
        whole = IntegerRange(from_value=0, to_value=255, step=1)
        for letter, (colour, value) in _BACKGROUND.items():
            text = f"{colour} channel of the background color"
            descriptor = ParameterDescriptor(description=text, integer_range=[whole])
            self.declare_parameter(f"background_{letter}", value, descriptor)
        text = "If true, then turtles will be holonomic"
        self.declare_parameter("holonomic", False, ParameterDescriptor(description=text))

    def log(self, level: str, text: str) -> None:
        """Write what happens in the world."""
        getattr(self.get_logger(), level)(text)

    def match_ports(self) -> None:
        """Give every turtle its topics and services, and take those of the gone ones back."""
        turtles = self.world.turtles
        for name, ports in list(self.ports.items()):
            if turtles.get(name) is not ports.turtle:
                self.ports.pop(name).destroy()
        for name in turtles.keys() - self.ports.keys():
            self.ports[name] = TurtlePorts(self, turtles[name])

    def spawn(self, request: Spawn.Request, response: Spawn.Response) -> Spawn.Response:
        """Add a turtle; the answer has its name, or none if that was taken."""
        turtle = self.world.spawn(request.x, request.y, request.theta, request.name)
        self.match_ports()
        response.name = "" if turtle is None else turtle.name
        return response

    def kill(self, request: Kill.Request, response: Kill.Response) -> Kill.Response:
        """Remove a turtle."""
        self.world.kill(request.name)
        self.match_ports()
        return response

    def clear(self, _request: Empty.Request, response: Empty.Response) -> Empty.Response:
        """Wipe out the lines."""
        self.world.clear()
        return response

    def reset(self, _request: Empty.Request, response: Empty.Response) -> Empty.Response:
        """Begin anew."""
        self.world.reset()
        self.match_ports()
        return response

    def tick(self) -> None:
        """Let 16 ms pass."""
        if self.world.tick():
            for name in sorted(self.ports):
                self.ports[name].publish()


def main() -> None:
    """Run until Ctrl-C."""
    with zbot.init():
        zbot.spin(TurtlesimNode())


if __name__ == "__main__":
    main()
