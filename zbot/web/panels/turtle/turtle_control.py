"""Control of turtles by messages, service calls and goals, shown as `zbot` commands."""

from __future__ import annotations

import itertools
import os
from typing import TYPE_CHECKING, Any, NamedTuple

from zbot.graph.snapshot import full_names
from zbot.interfaces import get_action, get_message, get_service
from zbot.names import fully_qualified
from zbot.node.node import Node
from zbot.observer.system import read_only_error
from zbot.parameters.parameter import Parameter
from zbot.web.forms.form import Form
from zbot.web.page.command_line import command_line
from zbot.web.page.service_call import answer, call, run_in_thread

if TYPE_CHECKING:
    from zbot.action import ActionClient
    from zbot.executor.task import Future
    from zbot.graph.snapshot import Snapshot
    from zbot.node.publisher import Publisher
    from zbot.observer.shared_entities import EntityReference
    from zbot.web.page.panel import Page

SCENE_TYPE = "zbot_msgs/srv/TurtleScene"
_SCENE = "/_scene"
_TWIST = "geometry_msgs/msg/Twist"
_ROTATE = "turtlesim/action/RotateAbsolute"
_EMPTY = "std_srvs/srv/Empty"
#: Forward in m/s and turn in rad/s, as in turtle_teleop_key.
ARROWS = {
    "ArrowUp": (2.0, 0.0),
    "ArrowDown": (-2.0, 0.0),
    "ArrowLeft": (0.0, 2.0),
    "ArrowRight": (0.0, -2.0),
}
#: Heading in rad for each letter: the direction from the key F to the letter's key. For example, G
#: is on the right of F, so its heading is 0.
HEADINGS = {
    "e": 2.3562,
    "r": 1.5708,
    "t": 0.7854,
    "d": 3.1416,
    "g": 0.0,
    "c": -2.3562,
    "v": -1.5708,
    "b": -0.7854,
}
CANCEL = "f"
_TELEOP = "teleop_turtle"
_DRIVER_DEPTH = 1
_numbers = itertools.count(1)  # for the node names of the second page and later pages


class Simulator(NamedTuple):
    """Running turtlesim node."""

    node: str  #: its full name
    namespace: str  #: the namespace of its services and turtles

    def name(self, relative: str) -> str:
        """Return the full name for a relative name such as `spawn` or `turtle1/pose`."""
        return fully_qualified(self.namespace, relative)

    @property
    def scene(self) -> str:
        """The name of the service that returns turtles and lines to draw."""
        return self.node + _SCENE


def simulators(graph: Snapshot) -> list[Simulator]:
    """Return the sorted running turtlesim nodes."""
    found = [name for name, types in graph.services() if SCENE_TYPE in types]
    nodes = (name.removesuffix(_SCENE) for name in found if name.endswith(_SCENE))
    return [Simulator(node, node.rpartition("/")[0] or "/") for node in nodes]


class TurtleControl:
    """Control that a page has over one simulator's turtles. Call its methods in NiceGUI's loop.

    Args:
        page: The page.
        simulator: The simulator.
    """

    def __init__(self, page: Page, simulator: Simulator) -> None:
        self._page = page
        self._system = page.system
        self.simulator = simulator
        self._driver: Node | None = None
        self._publishers: dict[str, Publisher[Any]] = {}
        self._clients: dict[str, EntityReference[ActionClient[Any, Any, Any]]] = {}
        self._goals: dict[str, Future[Any]] = {}
        page.on_close(self.close)

    def close(self) -> None:
        """Remove the page's own node and clients from the graph."""
        clients, self._clients = self._clients, {}
        for reference in clients.values():
            self._page.drop(reference)
        driver, self._driver = self._driver, None
        self._publishers.clear()
        if driver is not None and self._system.context.ok():
            driver.destroy_node()

    def drive(self, turtle: str, forward: float, turn: float) -> None:
        """Give a turtle a velocity (m/s, rad/s) for 1 s.

        Raises:
            ViewerError: The page is read-only.
        """
        if self._system.read_only:
            raise read_only_error("driving")
        twist: Any = get_message(_TWIST)()
        twist.linear.x, twist.angular.z = forward, turn
        topic = self.simulator.name(f"{turtle}/cmd_vel")
        if topic not in self._publishers:
            self._publishers[topic] = self._publisher(topic)
        self._publishers[topic].publish(twist)
        entries = {"linear.x": forward, "angular.z": turn}
        values = Form(type(twist)).yaml(entries)
        self._show("topic", "pub", "--once", topic, _TWIST, values)

    def _publisher(self, topic: str) -> Publisher[Any]:
        # The publisher has its own node, so that the graph is the same as with turtle_teleop_key.
        if self._driver is None:
            name = fully_qualified(self.simulator.namespace, _TELEOP)
            is_free = name not in full_names(self._system.snapshot().nodes)
            self._driver = Node(
                _TELEOP if is_free else f"_{_TELEOP}_{os.getpid()}_{next(_numbers)}",
                context=self._system.context,
                namespace=self.simulator.namespace,
                use_global_arguments=False,
                enable_rosout=False,
                start_parameter_services=False,
            )
        return self._driver.create_publisher(get_message(_TWIST), topic, _DRIVER_DEPTH)

    def prepare(self, turtle: str) -> None:
        """Create a turtle's action client early, because a new client needs time to connect."""
        if turtle not in self._clients and not self._system.read_only:
            reference = self._system.action_client(self._rotation(turtle), _ROTATE)
            self._clients[turtle] = self._page.keep(reference)

    def _rotation(self, turtle: str) -> str:
        return self.simulator.name(f"{turtle}/rotate_absolute")

    async def rotate(self, turtle: str, theta: float) -> None:
        """Turn a turtle to a heading in rad.

        Raises:
            ViewerError: The page is read-only.
            ServiceError: The turtle does not exist any more.
            NoAnswerError: The simulator did not answer in time.
        """
        if self._system.read_only:
            raise read_only_error("turning")
        values = f"{{theta: {theta}}}"
        self._show("action", "send_goal", self._rotation(turtle), _ROTATE, values)
        self.prepare(turtle)
        goal = get_action(_ROTATE).Goal(theta=theta)  # type: ignore[attr-defined] # each action has it
        sent = self._clients[turtle].entity.send_goal_to_server_async(goal)
        self._goals[turtle] = sent
        await answer(sent, self._rotation(turtle))

    async def cancel(self, turtle: str) -> None:
        """Stop a turtle's rotation."""
        sent = self._goals.pop(turtle, None)
        if sent is not None:
            goal: Any = await answer(sent, self._rotation(turtle))
            await answer(goal.cancel_goal_async(), self._rotation(turtle))

    async def call(self, relative: str, type_name: str, **values: Any) -> Any:
        """Call a service of the simulator. The keyword arguments are the fields of the request."""
        name = self.simulator.name(relative)
        request = get_service(type_name).Request(**values)  # type: ignore[attr-defined] # each service has it
        form = Form(type(request))
        words = [form.yaml(form.entries(request))] if values else []
        self._show("service", "call", name, type_name, *words)
        return await call(self._system, name, type_name, request)

    async def clear(self) -> None:
        """Remove all lines."""
        await self.call("clear", _EMPTY)

    async def reset(self) -> None:
        """Reset the simulator."""
        await self.call("reset", _EMPTY)

    async def spawn(self, x: float, y: float, theta: float, name: str) -> str:
        """Add a turtle and return its name, or an empty string if `name` is taken or invalid."""
        values = {"x": x, "y": y, "theta": theta, "name": name}
        response = await self.call("spawn", "turtlesim/srv/Spawn", **values)
        return str(response.name)

    async def kill(self, turtle: str) -> None:
        """Remove a turtle."""
        await self.call("kill", "turtlesim/srv/Kill", name=turtle)

    async def teleport(self, turtle: str, x: float, y: float, theta: float) -> None:
        """Move a turtle to a position."""
        relative, type_name = f"{turtle}/teleport_absolute", "turtlesim/srv/TeleportAbsolute"
        await self.call(relative, type_name, x=x, y=y, theta=theta)

    async def set_pen(
        self, turtle: str, colour: tuple[int, int, int], width: int, *, is_down: bool
    ) -> None:
        """Change a turtle's pen."""
        r, g, b = colour
        values = {"r": r, "g": g, "b": b, "width": width, "off": int(not is_down)}
        await self.call(f"{turtle}/set_pen", "turtlesim/srv/SetPen", **values)

    async def set_background(self, colour: tuple[int, int, int]) -> None:
        """Change the background."""
        values = {
            f"background_{channel}": value for channel, value in zip("rgb", colour, strict=True)
        }
        pairs = [word for name, value in values.items() for word in (name, str(value))]
        self._show("param", "set", self.simulator.node, *pairs)
        parameters = [Parameter(name, value=value) for name, value in values.items()]
        await run_in_thread(self._system.set_parameters, self.simulator.node, parameters)

    def _show(self, *words: str) -> None:
        self._page.show_command(command_line(*words))
