"""Node that moves a world, and publishes its time, its frames, its markers and its robots."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol

from zbot.executor.clock import Clock
from zbot.names import fully_qualified
from zbot.node.node import Node
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot.simulation.errors import SimulationError
from zbot.simulation.gazebo.names import TRANSPORT
from zbot.simulation.node.gazebo_services import GazeboServices
from zbot.simulation.node.gazebo_topics import GazeboTopics
from zbot.simulation.node.handles import Handles
from zbot.simulation.node.lockstep import Lockstep
from zbot.simulation.node.markers import WorldMarkers
from zbot.simulation.node.outbox import HeldPublisher, Outbox
from zbot.simulation.node.ports import CONNECTIONS_TOPIC, Ports, read_connections
from zbot.simulation.node.robot_topics import RobotTopics
from zbot.simulation.node.schedule import Schedule
from zbot.simulation.node.services import SimulationServices
from zbot.threads.deadline import Deadline
from zbot.time import ClockType, Time

from rosgraph_msgs.msg import Clock as ClockMessage
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from zbot.simulation.node.pace import Pace
    from zbot.simulation.robots.model import RobotModel
    from zbot.simulation.robots.robot import Robot
    from zbot.simulation.world import World
    from zbot.tf2.rigid import Rigid

_TICK_S = 0.004
#: Seconds without a look at commands and services, if the simulation runs as fast as possible.
_BUSY_S = 0.01
_LOCKSTEP_BUSY_S = 0.2
_CLOCK_RATE_HZ = 100.0
_MARKER_RATE_HZ = 10.0
_HANDLE_RATE_HZ = 5.0
_FOLLOW_PERIOD_S = 0.5
_CLOCK_TOPIC = "/clock"
_SLOW = 0.95
_LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
_BRIDGES = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class RunningControl(Protocol):
    """Controller manager of a robot in the simulator."""

    @property
    def rate_hz(self) -> float:
        """How often it is updated."""
        ...

    def update(self) -> None:
        """Run one period of the loop."""
        ...

    def release(self) -> None:
        """End the manager and its controllers."""
        ...


@dataclass(frozen=True)
class Gazebo:
    """How a simulator serves programs for Gazebo.

    Attributes:
        is_classic: Whether its services are those of Gazebo Classic.
        start_control: A function that starts the controller manager of a robot.
    """

    is_classic: bool = False
    start_control: Callable[[Simulator, Robot], RunningControl] | None = None


class Simulator(Node):
    """Simulator of one world.

    Args:
        world: The world. Only the thread that spins this node uses it.
        pace: How fast its time runs.
        has_world_frame: Whether the transforms from the world to the robots' odometry are
            published.
        in_lockstep: Whether the simulator waits for the nodes that follow its time.
        world_name: The name of the world in topics and services of Gazebo.
        gazebo: How it serves programs for Gazebo. None means that it has no services for them, and
            that each topic of Gazebo is a topic of ROS without a bridge.

    Attributes:
        lockstep: The lockstep with these nodes, if any.
        outbox: The messages of the present instant, which are sent after a step.

    Raises:
        SimulationError: Another node publishes the time of this domain.
    """

    def __init__(
        self,
        world: World,
        pace: Pace,
        *,
        has_world_frame: bool = True,
        in_lockstep: bool = False,
        world_name: str = "default",
        gazebo: Gazebo | None = None,
        **options: Any,
    ) -> None:
        self.outbox = Outbox()
        self.lockstep: Lockstep | None = None
        is_classic = gazebo is not None and gazebo.is_classic
        super().__init__("gazebo" if is_classic else "simulator", **options)
        self._refuse_a_second_time()
        self.lockstep = Lockstep(self) if in_lockstep else None
        self.world, self.pace, self._has_world_frame = world, pace, has_world_frame
        self.world_name, self._gazebo = world_name, gazebo or Gazebo()
        self.ports = Ports(self, is_open=gazebo is None)
        self._control: dict[str, Any] = {}  # controller managers by robot
        self.topics: dict[str, RobotTopics] = {}
        self.is_paused = False
        self._clock_publisher = self.create_publisher(ClockMessage, _CLOCK_TOPIC, 10)
        self._fixed_frames = self.create_publisher(TFMessage, "/tf_static", _LATCHED)
        self._walls = self.create_publisher(MarkerArray, "/simulation/world", _LATCHED)
        self._things = self.create_publisher(MarkerArray, "/simulation/things", _LATCHED)
        self._markers = WorldMarkers(world)
        self._schedules = [
            Schedule(_CLOCK_RATE_HZ, self._publish_time),
            Schedule(_MARKER_RATE_HZ, self._publish_things),
        ]
        self._walls.publish(self._markers.fixed())
        self._services = SimulationServices(self, is_classic=self._gazebo.is_classic)
        self._gazebo_times: list[Any] = []
        if gazebo is not None:
            self._serve_gazebo(gazebo)
        real = Clock(clock_type=ClockType.STEADY_TIME)
        self.create_timer(_TICK_S, self._tick, clock=real)
        self.create_timer(_FOLLOW_PERIOD_S, self._follow, clock=real)

    def _serve_gazebo(self, gazebo: Gazebo) -> None:
        """Offer the services of Gazebo, and follow its bridges."""
        GazeboServices(self, is_classic=gazebo.is_classic)
        self._gazebo_times = [
            self.ports.create_publisher(ClockMessage, f"{TRANSPORT}{topic}", 10)
            for topic in (f"/world/{self.world_name}/clock", "/clock")
        ]
        self.create_subscription(String, CONNECTIONS_TOPIC, self._connect, _BRIDGES)

    def show_handles(self) -> None:
        """Let users move robots and things in the 3D view."""
        self._schedules.append(Schedule(_HANDLE_RATE_HZ, Handles(self, self).update))

    def create_publisher(self, *args: Any, **options: Any) -> Any:
        """Create a publisher. In lockstep, its messages are sent after a step."""
        publisher = super().create_publisher(*args, **options)
        return publisher if self.lockstep is None else HeldPublisher(publisher, self.outbox)

    def destroy_publisher(self, publisher: Any) -> bool:
        """Destroy a publisher of `create_publisher`."""
        is_held = isinstance(publisher, HeldPublisher)
        return super().destroy_publisher(publisher.publisher if is_held else publisher)

    def _refuse_a_second_time(self) -> None:
        others = self.get_publishers_info_by_topic(_CLOCK_TOPIC)
        if others:
            name = f"{others[0].node_namespace.rstrip('/')}/{others[0].node_name}"
            raise SimulationError(
                f"the node {name} publishes {_CLOCK_TOPIC} in this domain already: end it, or "
                "choose another domain with ZBOT_DOMAIN_ID"
            )

    @property
    def stamp(self) -> Any:
        """The time in the world, as a message."""
        return Time(nanoseconds=self.world.time_ns).to_msg()

    def add_robots(
        self, robots: Iterable[tuple[str, str, RobotModel, Rigid]], *, on_floor: bool = True
    ) -> None:
        """Add robots: their names, their namespaces, their models and where they start.

        Args:
            robots: The robots.
            on_floor: Whether the height of a pose is that of the floor, not that of the root.

        Raises:
            SimulationError: A robot cannot be made. Then none is added.
        """
        robots = list(robots)
        rows = ((name, model, pose) for name, _, model, pose in robots)
        added = self.world.add(rows, on_floor=on_floor)
        for robot, (_, namespace, _, _) in zip(added, robots, strict=True):
            self.topics[robot.name] = self._new_topics(robot, namespace)
            for notice in dict.fromkeys(robot.notices):
                self.get_logger().warning(f"{robot.name}: {notice} is left out")
        self._publish_fixed_frames()

    def _new_topics(self, robot: Robot, namespace: str) -> RobotTopics:
        if not robot.model.is_gazebo:
            has_world = self._has_world_frame
            return RobotTopics(self, self.world, robot, namespace, has_world=has_world)
        topics = GazeboTopics(self.ports, self.world, robot)
        if robot.model.equipment.control is not None and self._gazebo.start_control is not None:
            control = self._gazebo.start_control(self, robot)
            self._control[robot.name] = control
            topics.schedules.append(Schedule(control.rate_hz, control.update))
        return topics

    def _connect(self, message: Any) -> None:
        """Use the connections that a bridge wants."""
        bridge, _, text = message.data.partition("\n")
        try:
            self.ports.want(bridge, read_connections(text))
        except SimulationError as error:
            self.get_logger().warning(f"The bridge {bridge[:100]} is not understood: {error}")

    def _bridges(self) -> list[str]:
        """Return the names of the bridges that run."""
        known = self.get_publishers_info_by_topic(CONNECTIONS_TOPIC)
        return [fully_qualified(info.node_namespace, info.node_name) for info in known]

    def remove_robot(self, name: str) -> None:
        """Remove a robot."""
        control = self._control.pop(name, None)
        if control is not None:
            control.release()
        self.topics.pop(name).release()
        self.world.remove(name)
        self._publish_fixed_frames()

    def reset(self, *, time_too: bool) -> None:
        """Put all bodies back to where they started."""
        self.world.reset()
        if time_too:
            self.world.steps = 0
        for schedule in self._schedules:
            schedule.reset()
        for topics in self.topics.values():
            topics.reset()
        self._publish_things()

    def step(self) -> None:
        """Move the world for one step, and publish what is due."""
        self.world.step()
        now_ns, stamp = self.world.time_ns, self.stamp
        for schedule in self._schedules:
            schedule.run(now_ns)
        for topics in self.topics.values():
            topics.run(stamp, now_ns)
        if self.lockstep is not None:
            self.send()

    def send(self) -> None:
        """Send all messages of this instant, and wait for the nodes that follow the time."""
        lockstep = self.lockstep
        if lockstep is None:
            return
        if lockstep.notice_changes():
            for topics in self.topics.values():
                topics.follow_commands()
        self.outbox.send(lambda: lockstep.settle(self.world.time_ns))

    def _tick(self) -> None:
        """Do the steps that are due."""
        # In lockstep, other work is done during each wait.
        turn = Deadline(_BUSY_S if self.lockstep is None else _LOCKSTEP_BUSY_S)
        while not self.is_paused and self.pace.is_due(self.world.step_s):
            self.step()
            reached = self.pace.count(self.world.step_s)
            wanted = self.pace.factor
            if reached is not None and wanted is not None and reached < _SLOW * wanted:
                self.get_logger().warning(
                    f"The simulation runs at {reached:.2f} of the real time, not {wanted:g}: this "
                    "machine is busy",
                    throttle_duration_sec=60.0,
                )
            if turn.is_over:
                break

    def _follow(self) -> None:
        if self._gazebo_times:
            self.ports.keep_only(self._bridges())
        if self.world.broke_down:
            self.get_logger().warning(
                "The physics broke down, because values became too large: all bodies are back "
                "where they started",
                once=True,
            )
        for topics in self.topics.values():
            topics.follow_commands()
            if topics.robot.is_lost:
                self.get_logger().warning(f"{topics.robot.name} fell out of the world: it is back")
                topics.robot.pose = topics.robot.start
                topics.robot.stop()
                self.world.refresh()

    def _publish_time(self) -> None:
        message = ClockMessage(clock=self.stamp)
        self._clock_publisher.publish(message)
        for port in self._gazebo_times:
            port.publish(message)

    def _publish_fixed_frames(self) -> None:
        stamp = self.stamp
        frames = [frame for topics in self.topics.values() for frame in topics.frames.fixed(stamp)]
        self._fixed_frames.publish(TFMessage(transforms=frames))

    def _publish_things(self) -> None:
        markers = self._markers.moving()
        if markers is not None:
            self._things.publish(markers)
