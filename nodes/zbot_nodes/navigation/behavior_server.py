"""Move a robot a little: turn, back up, drive ahead, or wait.

Run:        zbot run nav2_behaviors behavior_server, then configure and activate it
Actions:    spin, backup, drive_on_heading, wait, assisted_teleop (all of nav2_msgs)
Subscribes: local_costmap/costmap (nav_msgs/OccupancyGrid), cmd_vel_teleop (geometry_msgs/Twist)
Publishes:  cmd_vel (geometry_msgs/Twist, or TwistStamped with enable_stamped_cmd_vel)
"""

from __future__ import annotations

import math
from typing import Any

from zbot.qos import DurabilityPolicy, QoSProfile
from zbot.time import Duration
from zbot_nodes.navigation.grids.footprint import leads_away
from zbot_nodes.navigation.grids.geometry import cells_of, geometry_of, is_whole
from zbot_nodes.navigation.grids.pursuit import Velocity, arc
from zbot_nodes.navigation.managed_server import ManagedServer, Ticker, end_goal
from zbot_nodes.navigation.velocity_publisher import VelocityPublisher
from zbot_nodes.robot.pose import Pose, turn_to
from zbot_nodes.startup.program import run_node

from geometry_msgs.msg import Twist
from nav2_msgs.action import AssistedTeleop, BackUp, DriveOnHeading, Spin, Wait
from nav_msgs.msg import OccupancyGrid

_KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
_TOUCHING_PERCENT, _OCCUPIED_PERCENT = 99, 100
_LOOK_S = 1.0  # how far ahead in time an obstacle counts
_SILENT_S = 0.5  # a person who drives sends commands more often


class BehaviorError(Exception):
    """A behaviour had to stop.

    Args:
        name: The name of the error code, which all behaviours have.
        text: What is wrong.
    """

    def __init__(self, name: str, text: str) -> None:
        self.name = name
        super().__init__(text)


class BehaviorServer(ManagedServer):
    """Does one behaviour at a time.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__("behavior_server", **options)
        self.costmap: OccupancyGrid | None = None
        self.teleop, self.teleop_s = Velocity(), -math.inf

    def configure(self) -> None:
        """Create the topics and the actions."""
        settings = self.settings
        self.period_s = 1 / max(settings.number("cycle_frequency", 10.0), 1.0)
        self.frame = settings.first_text(("local_frame", "global_frame"), "odom")
        self.base_frame = settings.text("robot_base_frame", "base_link")
        self.turn_speed = settings.number("max_rotational_vel", 1.0)
        self.slowest_turn = settings.number("min_rotational_vel", 0.4)
        self.turn_acceleration = settings.number("rotational_acc_lim", 3.2)
        topic = settings.first_text(
            ("local_costmap_topic", "costmap_topic"), "local_costmap/costmap_raw"
        )
        plugins = settings.texts("behavior_plugins", []) + settings.texts("recovery_plugins", [])
        for name in plugins:
            settings.text(f"{name}.plugin", "")
        self.velocities = VelocityPublisher(self, "cmd_vel")
        self.inputs: list[Any] = [
            self.create_subscription(
                OccupancyGrid, topic.removesuffix("_raw"), self.take_costmap, _KEPT
            ),
            self.create_subscription(Twist, "cmd_vel_teleop", self.take_teleop, 10),
        ]
        self.create_action(Spin, "spin", self.spin)
        self.create_action(BackUp, "backup", self.back_up)
        self.create_action(DriveOnHeading, "drive_on_heading", self.drive_on_heading)
        self.create_action(Wait, "wait", self.wait)
        self.create_action(AssistedTeleop, "assisted_teleop", self.assist)

    def clean_up(self) -> None:
        """Destroy the topics."""
        self.velocities.close()
        for entity in self.inputs:
            self.destroy_subscription(entity)

    def take_costmap(self, message: OccupancyGrid) -> None:
        """Store the costs around the robot."""
        if is_whole(message):
            self.costmap = message

    def take_teleop(self, message: Twist) -> None:
        """Store what a person commands."""
        self.teleop = Velocity(message.linear.x, message.angular.z)
        self.teleop_s = self.seconds()

    # -- the behaviours ------------------------------------------------------------------------

    async def spin(self, handle: Any) -> Any:
        """Turn on the spot by the angle of a goal."""
        goal = handle.request
        return await self.run("spin", handle, Spin.Result(), self.turning(handle, goal))

    def turning(self, handle: Any, goal: Any) -> Any:
        """Return a function that says how fast the robot turns at each pose."""
        turned, last = 0.0, None

        def step(pose: Pose) -> Velocity | None:
            nonlocal turned, last
            turned += 0.0 if last is None else turn_to(pose.yaw - last)
            last = pose.yaw
            handle.publish_feedback(Spin.Feedback(angular_distance_traveled=abs(turned)))
            left = goal.target_yaw - turned
            if left * goal.target_yaw <= 0:
                return None
            stopping = math.sqrt(2 * self.turn_acceleration * abs(left)) * 0.7
            speed = max(self.slowest_turn, min(self.turn_speed, stopping))
            return Velocity(0.0, math.copysign(speed, goal.target_yaw))

        return step

    async def back_up(self, handle: Any) -> Any:
        """Drive back by the distance of a goal."""
        goal = handle.request
        step = self.driving(handle, -abs(goal.target.x), abs(goal.speed), BackUp.Feedback)
        return await self.run("backup", handle, BackUp.Result(), step)

    async def drive_on_heading(self, handle: Any) -> Any:
        """Drive straight by the distance of a goal."""
        goal, kind = handle.request, DriveOnHeading
        if goal.target.x * goal.speed <= 0:
            text = "the distance and the speed must have the same sign"
            return end_goal(handle, kind.Result(), kind.Result.INVALID_INPUT, text)
        step = self.driving(handle, goal.target.x, abs(goal.speed), kind.Feedback)
        return await self.run("drive_on_heading", handle, kind.Result(), step)

    def driving(self, handle: Any, way_m: float, speed: float, kind: Any) -> Any:
        """Return a function that says how fast the robot drives at each pose."""
        start: Pose | None = None

        def step(pose: Pose) -> Velocity | None:
            nonlocal start
            start = start or pose
            done_m = math.hypot(pose.x - start.x, pose.y - start.y)
            handle.publish_feedback(kind(distance_traveled=done_m))
            return Velocity(math.copysign(speed, way_m)) if done_m < abs(way_m) else None

        return step

    async def wait(self, handle: Any) -> Any:
        """Stand still for the time of a goal."""
        end_s = self.seconds() + Duration.from_msg(handle.request.time).nanoseconds / 1e9

        def step(_pose: Pose) -> Velocity | None:
            left_s = end_s - self.seconds()
            left = Duration(seconds=max(left_s, 0.0)).to_msg()
            handle.publish_feedback(Wait.Feedback(time_left=left))
            return Velocity() if left_s > 0 else None

        return await self.run("wait", handle, Wait.Result(), step)

    async def assist(self, handle: Any) -> Any:
        """Drive as a person commands, and stop before obstacles."""

        def step(_pose: Pose) -> Velocity:
            if self.seconds() - self.teleop_s > _SILENT_S:
                return Velocity()
            try:
                self.refuse_collision(self.teleop)
            except BehaviorError:
                return Velocity(0.0, self.teleop.turn)
            return self.teleop

        return await self.run("assisted_teleop", handle, AssistedTeleop.Result(), step)

    # -- how they run --------------------------------------------------------------------------

    async def run(self, name: str, handle: Any, result: Any, step: Any) -> Any:
        """Command what a function says until it says None, and end the goal."""
        self.get_logger().info(f"Running {name}")
        begin_s, ticker = self.seconds(), Ticker(self, self.period_s)
        code, text = 0, ""
        try:
            while self.is_wanted(name, handle):
                velocity = self.velocity(handle.request, begin_s, step)
                if velocity is None:
                    break
                self.velocities.publish(*velocity)
                await ticker.next()
        except BehaviorError as error:
            text, code = str(error), getattr(type(result), error.name, type(result).UNKNOWN)
            self.get_logger().warning(f"{name} stopped: {text}")
        finally:
            ticker.close()
            if name != "wait":
                self.velocities.publish(0.0, 0.0)
        result.total_elapsed_time = Duration(seconds=self.seconds() - begin_s).to_msg()
        if not code and not self.is_newest(name, handle):
            code, text = type(result).UNKNOWN, "a newer goal came"
        return end_goal(handle, result, code, text)

    def velocity(self, goal: Any, begin_s: float, step: Any) -> Velocity | None:
        """Return the next velocity, or None at the end.

        Raises:
            BehaviorError: The time is over, the pose is not known, or an obstacle is in the way.
        """
        allowed = getattr(goal, "time_allowance", None)
        allowed_s = 0.0 if allowed is None else Duration.from_msg(allowed).nanoseconds / 1e9
        if allowed_s and self.seconds() - begin_s > allowed_s:
            raise BehaviorError("TIMEOUT", f"it took longer than {allowed_s:g} s")
        pose = self.frames.pose(self.frame, self.base_frame)
        if pose is None:
            raise BehaviorError("TF_ERROR", f"the robot has no pose in the frame {self.frame}")
        velocity: Velocity | None = step(pose)
        is_checked = not getattr(goal, "disable_collision_checks", True)
        if velocity is not None and is_checked:
            self.refuse_collision(velocity)
        return velocity

    def refuse_collision(self, velocity: Velocity) -> None:
        """Check what the robot would touch soon.

        Raises:
            BehaviorError: An obstacle is in the way.
        """
        message = self.costmap
        if message is None or velocity == Velocity():
            return
        frame = message.header.frame_id
        start = self.frames.pose(frame, self.base_frame)
        if start is None:
            raise BehaviorError("TF_ERROR", f"the robot has no pose in the frame {frame}")
        cells, geometry = cells_of(message), geometry_of(message.info)
        touching = cells >= _TOUCHING_PERCENT
        poses = [start @ step for step in arc(velocity, _LOOK_S, geometry.resolution)]
        at = [cell for pose in poses if (cell := geometry.cell(pose.x, pose.y)) is not None]
        if not any(touching[cell] for cell in at):
            return
        here = geometry.cell(start.x, start.y)
        is_near = here is not None and bool(touching[here])
        if not (is_near and leads_away(start, poses[-1], cells == _OCCUPIED_PERCENT, geometry)):
            raise BehaviorError("COLLISION_AHEAD", "an obstacle is in the way")


def main() -> None:
    """Run until Ctrl-C."""
    run_node(BehaviorServer)


if __name__ == "__main__":
    main()
