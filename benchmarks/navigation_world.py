"""World and nodes of navigation in one process, whose time waits for all of them.

The simulator does a few steps, and then all nodes do all their work, before the time goes on. So a
run does not depend on how busy the machine is, and takes as long as its work.
"""

from __future__ import annotations

import math
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ros_gz_interfaces.msg import Contacts

import zbot
from zbot.action import ActionClient
from zbot.simulation.node.pace import Pace
from zbot.simulation.node.program import Options, robots_of
from zbot.simulation.node.simulator import Simulator
from zbot.simulation.world import World
from zbot.simulation.worlds.file import find_world

from action_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped
from nav2_msgs.action import NavigateToPose

if TYPE_CHECKING:
    from collections.abc import Callable

_ROOT = Path(__file__).parents[1]
PARAMETERS = _ROOT / "launch" / "nav2_bringup" / "params" / "nav2_params.yaml"
_STEPS = 2  # 8 ms in the world: less than the time between two messages of /clock
_IDLE_S = 0.001  # nodes that have had nothing to do for so long are done
_LATE_S = 5.0


def place_in_map(start: tuple[float, float, float], x: float, y: float) -> tuple[float, float]:
    """Return a place of the world in a map that begins at a pose."""
    cos, sin = math.cos(start[2]), math.sin(start[2])
    x, y = x - start[0], y - start[1]
    return x * cos + y * sin, y * cos - x * sin


class NavigationWorld:
    """World with one robot, and the nodes that see and drive it.

    Args:
        world: The name of the world.
        domain_id: The domain of all nodes.
        seed: The seed of all noise.
        steps: How many steps of 4 ms the world does before the nodes work.

    Attributes:
        touched: What the robot has touched.
        error: Why the last goal was not reached.
    """

    def __init__(self, world: str, domain_id: int, *, seed: int = 0, steps: int = _STEPS) -> None:
        self.context = context = zbot.Context()
        words = ["--ros-args", "--params-file", str(PARAMETERS)]
        context.init(words, domain_id=domain_id)
        self.executor = zbot.SingleThreadedExecutor(context=context)
        found = find_world(world)
        self.world = World(found.spec, seed=seed)
        self.simulator = Simulator(self.world, Pace(None), has_world_frame=False, context=context)
        self.simulator.add_robots(robots_of(Options(), self.world, found.start))
        self.simulator.is_paused = True  # this object does the steps
        self.nodes: list[zbot.Node] = []
        self.executor.add_node(self.simulator)
        self.touched: list[str] = []
        self.error, self._steps = "", steps
        self.client_node = self.add(lambda **options: zbot.Node("goals", **options))
        self.goals = ActionClient[Any, Any, Any](
            self.client_node, NavigateToPose, "navigate_to_pose"
        )
        self.client_node.create_subscription(Contacts, "bumper", self._feel, 10)
        self.start = self.true_pose()

    def add(self, make: Callable[..., Any], parameters: dict[str, Any] | None = None) -> Any:
        """Create a node with parameters, and configure and activate it."""
        given = {"use_sim_time": True, **(parameters or {})}
        overrides = [zbot.Parameter(name, value=value) for name, value in given.items()]
        node = make(context=self.context, parameter_overrides=overrides)
        self.nodes.append(node)
        self.executor.add_node(node)
        if hasattr(node, "trigger_configure"):
            node.trigger_configure()
            node.trigger_activate()
        return node

    def _feel(self, message: Any) -> None:
        self.touched += [contact.collision2.name for contact in message.contacts]

    @property
    def time_s(self) -> float:
        """The time in the world."""
        return self.world.time_ns / 1e9

    def true_pose(self) -> tuple[float, float, float]:
        """Return the pose of the robot in the world."""
        pose = next(iter(self.world.robots.values())).pose
        (x, y, _), (_, _, z, w) = pose
        return x, y, 2 * math.atan2(z, w)

    def in_map(self, x: float, y: float) -> tuple[float, float]:
        """Return a place of the world in a map that begins where the robot started."""
        return place_in_map(self.start, x, y)

    def run(self, seconds: float) -> None:
        """Let some time pass in the world."""
        end_s = self.time_s + seconds
        while self.time_s < end_s:
            self.step()

    def step(self) -> None:
        """Do a few steps, and let all nodes do their work."""
        for _ in range(self._steps):
            self.simulator.step()
        now_ns = self.world.time_ns - 10_000_000  # the time is published at 100 Hz
        late_s = time.monotonic() + _LATE_S
        while True:
            begin_s = time.monotonic()
            self.executor.spin_once(_IDLE_S)
            is_idle = time.monotonic() - begin_s >= _IDLE_S
            if is_idle and (begin_s > late_s or self._have(now_ns)):
                return

    def _have(self, now_ns: int) -> bool:
        return all(node.get_clock().now().nanoseconds >= now_ns for node in self.nodes)

    def wait(self, is_done: Callable[[], bool], limit_s: float) -> bool:
        """Let time pass until a condition holds. Return whether it does."""
        end_s = self.time_s + limit_s
        while not is_done():
            if self.time_s > end_s:
                return False
            self.step()
        return True

    def go(self, x: float, y: float, yaw: float = 0.0, *, limit_s: float = 120.0) -> bool:
        """Send the robot to a place of the map. Return whether navigation says it is there."""
        pose = PoseStamped()
        pose.header.frame_id = "map"
        pose.pose.position.x, pose.pose.position.y = x, y
        pose.pose.orientation.z, pose.pose.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
        sent = self.goals.send_goal_async(NavigateToPose.Goal(pose=pose))
        if not self.wait(sent.done, 10.0):
            return False
        handle: Any = sent.result()
        if not handle.accepted:
            return False
        result = handle.get_result_async()
        self.wait(result.done, limit_s)
        answer: Any = result.result() if result.done() else None
        self.error = "" if answer is None else answer.result.error_msg
        return answer is not None and answer.status == GoalStatus.STATUS_SUCCEEDED

    def away_m(self, x: float, y: float) -> float:
        """Return how far the robot truly is from a place of the map."""
        return math.dist((x, y), self.in_map(*self.true_pose()[:2]))

    def close(self) -> None:
        """Destroy all nodes."""
        self.executor.shutdown()
        self.context.shutdown()


def start_drivers(world: NavigationWorld) -> None:
    """Start all nodes that drive a robot to goals."""
    from zbot_nodes.navigation.behavior_server import BehaviorServer  # noqa: PLC0415 - with numpy
    from zbot_nodes.navigation.bt_navigator import BtNavigator  # noqa: PLC0415 - as above
    from zbot_nodes.navigation.controller_server import ControllerServer  # noqa: PLC0415
    from zbot_nodes.navigation.planner_server import PlannerServer  # noqa: PLC0415 - as above

    for kind in (PlannerServer, ControllerServer, BehaviorServer, BtNavigator):
        world.add(kind)
