"""Simulate turtles that draw.

Run:        zbot run turtlesim turtlesim_node
            zbot run turtlesim turtlesim_node --no-browser
Drive:      with the arrow keys in its page, or zbot run turtlesim turtle_teleop_key
Subscribes: /turtle1/cmd_vel (geometry_msgs/msg/Twist); every turtle has its own topics
Publishes:  /turtle1/pose (turtlesim/msg/Pose), /turtle1/color_sensor (turtlesim/msg/Color)
Serves:     /spawn /kill /clear /reset, /turtle1/set_pen, /turtle1/teleport_absolute,
            /turtle1/teleport_relative, and the action /turtle1/rotate_absolute
Parameters: background_r, background_g, background_b (0 to 255), holonomic (bool)
"""

from __future__ import annotations

from urllib.parse import quote

import zbot
from zbot.errors import InvalidTopicNameError
from zbot.names import validate_topic_name
from zbot.remote.parameter_event_handler import ParameterEventHandler
from zbot_nodes.startup.page import shown
from zbot_nodes.turtlesim.ports import TurtlePorts
from zbot_nodes.turtlesim.scene import SCENE, Scene
from zbot_nodes.turtlesim.world import TICK_S, TurtleWorld

from rcl_interfaces.msg import IntegerRange, Parameter, ParameterDescriptor
from std_srvs.srv import Empty
from turtlesim.msg import Color
from turtlesim.srv import Kill, Spawn
from zbot_msgs.srv import TurtleScene

_BACKGROUND = {"r": ("Red", 69), "g": ("Green", 86), "b": ("Blue", 255)}


class TurtlesimNode(zbot.Node):
    """Node with a world of turtles, and the topics, services and action of each turtle."""

    def __init__(self) -> None:
        super().__init__("turtlesim")
        name = self.get_fully_qualified_name()
        self.get_logger().info(f"Starting turtlesim with node name {name}")
        self.declare_settings()
        self.ports: dict[str, TurtlePorts] = {}
        self.world = TurtleWorld(self.log)
        self.scene = Scene(self.world)
        self.paint()
        self.match_ports()
        self.create_service(Spawn, "spawn", self.spawn)
        self.create_service(Kill, "kill", self.kill)
        self.create_service(Empty, "clear", self.clear)
        self.create_service(Empty, "reset", self.reset)
        self.create_service(TurtleScene, SCENE, self.scene.fill_response)
        events = ParameterEventHandler(self)
        for letter in _BACKGROUND:
            events.add_parameter_callback(f"background_{letter}", "", self.paint)
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

    def paint(self, _changed: Parameter | None = None) -> None:
        """Set the background to the colour of the parameters."""
        channels = {
            channel: self.get_parameter(f"background_{channel}").value for channel in _BACKGROUND
        }
        self.scene.background = Color(**channels)

    def log(self, level: str, text: str) -> None:
        """Log an event in the world."""
        logger = self.get_logger()
        # There are three calls, because the severity of one log call must not change.
        if level == "info":
            logger.info(text)
        elif level == "warning":
            logger.warning(text)
        else:
            logger.error(text)

    def match_ports(self) -> None:
        """Create the entities of new turtles, and destroy the entities of removed turtles."""
        turtles = self.world.turtles
        for name, ports in list(self.ports.items()):
            if turtles.get(name) is not ports.turtle:
                self.ports.pop(name).destroy()
        for name in turtles.keys() - self.ports.keys():
            self.ports[name] = TurtlePorts(self, self.world, turtles[name])

    def spawn(self, request: Spawn.Request, response: Spawn.Response) -> Spawn.Response:
        """Add a turtle. The response's name is empty if the requested name is taken or invalid."""
        if request.name and not self.is_possible(request.name):
            return response
        turtle = self.world.spawn(request.x, request.y, request.theta, request.name)
        self.match_ports()
        response.name = "" if turtle is None else turtle.name
        return response

    def is_possible(self, name: str) -> bool:
        """Return whether a turtle's name can be part of topic names. Log an error if it cannot."""
        try:
            validate_topic_name(f"{name}/pose")
        except InvalidTopicNameError as error:
            self.get_logger().error(f"A turtle cannot be named [{name}]: {error}")
            return False
        return True

    def kill(self, request: Kill.Request, response: Kill.Response) -> Kill.Response:
        """Remove a turtle."""
        self.world.kill(request.name)
        self.match_ports()
        return response

    def clear(self, _request: Empty.Request, response: Empty.Response) -> Empty.Response:
        """Clear the drawing."""
        self.world.clear()
        return response

    def reset(self, _request: Empty.Request, response: Empty.Response) -> Empty.Response:
        """Start again with one turtle."""
        self.world.reset()
        self.match_ports()
        return response

    def tick(self) -> None:
        """Advance the world by 16 ms."""
        if self.world.tick():
            for name in sorted(self.ports):
                self.ports[name].publish()


def main() -> None:
    """Run until Ctrl-C."""
    with zbot.init():
        node = TurtlesimNode()
        panel = f"/turtle?node={quote(node.get_fully_qualified_name())}"
        with shown(node, panel, "turtles"):
            zbot.spin(node)


if __name__ == "__main__":
    main()
