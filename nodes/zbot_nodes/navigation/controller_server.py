"""Drive a robot along a path, and stop before obstacles.

Run:        zbot run nav2_controller controller_server, then configure and activate it
Action:     follow_path (nav2_msgs/FollowPath)
Subscribes: speed_limit (nav2_msgs/SpeedLimit)
Publishes:  cmd_vel (geometry_msgs/Twist, or TwistStamped with enable_stamped_cmd_vel),
            lookahead_point (geometry_msgs/PointStamped), received_global_plan (nav_msgs/Path);
            and what its costmap publishes, in local_costmap/
"""

from __future__ import annotations

import math
from typing import Any

from zbot_nodes.navigation.costmap import Costmap
from zbot_nodes.navigation.followed_path import FollowedPath, GoalCheck, ProgressCheck
from zbot_nodes.navigation.grids import np
from zbot_nodes.navigation.grids.costs import OBSTACLE
from zbot_nodes.navigation.grids.footprint import leads_away
from zbot_nodes.navigation.grids.pursuit import PursuitRules, Velocity, ahead, arc
from zbot_nodes.navigation.managed_server import ManagedServer, Ticker, end_goal
from zbot_nodes.navigation.robot_frames import pose_in
from zbot_nodes.navigation.velocity_publisher import VelocityPublisher
from zbot_nodes.robot.pose import Pose, turn_to
from zbot_nodes.startup.program import run_node

from geometry_msgs.msg import PointStamped
from nav2_msgs.action import FollowPath
from nav2_msgs.msg import SpeedLimit
from nav_msgs.msg import Path

_ERRORS = FollowPath.Result
_SLOWER = (1.0, 0.5, 0.25)


class ControlError(Exception):
    """The robot cannot follow its path.

    Args:
        code: A constant of the action's result.
        text: What is wrong.
    """

    def __init__(self, code: int, text: str) -> None:
        self.code = code
        super().__init__(text)


class ControllerServer(ManagedServer):
    """Follows one path at a time.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__("controller_server", **options)
        self.costmap: Costmap | None = None
        self.limit = math.inf  #: m/s
        self.last = Velocity()

    def configure(self) -> None:
        """Create the costmap, the topics and the action."""
        settings = self.settings
        self.period_s = 1 / max(settings.number("controller_frequency", 20.0), 1.0)
        self.failure_s = settings.number("failure_tolerance", 0.0)
        names = settings.texts("controller_plugins", ["FollowPath"])
        self.controllers = {name: self.rules(name) for name in names}
        self.goal_checks = {
            name: (
                settings.number(f"{name}.xy_goal_tolerance", 0.25),
                settings.number(f"{name}.yaw_goal_tolerance", 0.25),
            )
            for name in settings.texts("goal_checker_plugins", ["goal_checker"])
        }
        progress = settings.texts("progress_checker_plugins", []) or [
            settings.text("progress_checker_plugin", "progress_checker")
        ]
        self.least_way_m = settings.number(f"{progress[0]}.required_movement_radius", 0.5)
        self.patience_s = settings.number(f"{progress[0]}.movement_time_allowance", 10.0)
        for name in (*names, *self.goal_checks, *progress):
            for key in ("plugin", "stateful", "primary_controller"):
                settings.value(f"{name}.{key}", "")
        self.costmap = Costmap("local_costmap", self, is_rolling=True)
        if self.executor is not None:
            self.executor.add_node(self.costmap)
        self.velocities = VelocityPublisher(self, "cmd_vel")
        self.plans = self.create_publisher(Path, "received_global_plan", 10)
        self.points = self.create_publisher(PointStamped, "lookahead_point", 10)
        topic = settings.text("speed_limit_topic", "speed_limit")
        self.limits = self.create_subscription(SpeedLimit, topic, self.set_limit, 10)
        self.create_action(FollowPath, "follow_path", self.follow)

    def rules(self, name: str) -> PursuitRules:
        """Return how a controller drives. The parameters of several controllers are understood."""

        def first(default: float, *keys: str) -> float:
            return self.settings.first(tuple(f"{name}.{key}" for key in keys), default)

        usual = PursuitRules()
        speeds = ("desired_linear_vel", "max_linear_vel", "max_vel_x", "vx_max", "v_linear_max")
        turns = ("rotate_to_heading_angular_vel", "max_vel_theta", "wz_max", "v_angular_max")
        speed = first(usual.speed, *speeds)
        self.settings.flag(f"{name}.use_collision_detection", default=True)
        self.collision_s = first(1.0, "max_allowed_time_to_collision_up_to_carrot")
        return PursuitRules(
            speed=speed,
            turn_speed=first(usual.turn_speed, *turns),
            turn_acceleration=first(usual.turn_acceleration, "max_angular_accel", "acc_lim_theta"),
            look_time_s=first(usual.look_time_s, "lookahead_time"),
            nearest_look_m=first(usual.nearest_look_m, "min_lookahead_dist"),
            farthest_look_m=first(usual.farthest_look_m, "max_lookahead_dist", "lookahead_dist"),
            turn_angle=first(
                usual.turn_angle, "rotate_to_heading_min_angle", "angular_dist_threshold"
            ),
            narrow_radius_m=first(usual.narrow_radius_m, "regulated_linear_scaling_min_radius"),
            slowest=min(speed, first(usual.slowest, "regulated_linear_scaling_min_speed")),
            approach_m=first(usual.approach_m, "approach_velocity_scaling_dist"),
            approach_slowest=first(usual.approach_slowest, "min_approach_linear_velocity"),
        )

    def clean_up(self) -> None:
        """Destroy the costmap and the topics."""
        for publisher in (self.plans, self.points):
            self.destroy_publisher(publisher)
        self.velocities.close()
        self.destroy_subscription(self.limits)
        if self.costmap is not None:
            self.costmap.destroy_node()
        self.costmap = None

    def set_limit(self, message: SpeedLimit) -> None:
        """Drive at most so fast from now on."""
        fastest = max(rules.speed for rules in self.controllers.values())
        limit = message.speed_limit * (fastest / 100 if message.percentage else 1.0)
        self.limit = limit or math.inf

    # -- following a path ----------------------------------------------------------------------

    async def follow(self, handle: Any) -> Any:
        """Follow the path of a goal until its end."""
        result, ticker = FollowPath.Result(), Ticker(self, self.period_s)
        code, text = 0, ""
        try:
            await self.drive(handle, ticker)
        except ControlError as error:
            code, text = error.code, str(error)
            self.get_logger().error(text)
        finally:
            ticker.close()
            if self.is_newest("follow_path", handle):
                self.command(Velocity())
        if not code and not self.is_newest("follow_path", handle):
            code, text = _ERRORS.UNKNOWN, "a newer path came"
        return end_goal(handle, result, code, text)

    async def drive(self, handle: Any, ticker: Ticker) -> None:
        """Drive until the end of the path, or until the goal is not wanted any more.

        Raises:
            ControlError: The robot cannot follow the path.
        """
        rules = self.chosen(self.controllers, handle.request.controller_id)
        check = GoalCheck(*self.chosen(self.goal_checks, handle.request.goal_checker_id))
        progress = ProgressCheck(self.least_way_m, self.patience_s)
        message = handle.request.path
        if not message.poses:
            raise ControlError(_ERRORS.INVALID_PATH, "the path has no poses")
        self.plans.publish(message)
        path = FollowedPath([pose_in(pose) for pose in message.poses])
        frame = message.header.frame_id or message.poses[0].header.frame_id
        blocked_since: float | None = None
        while self.is_wanted("follow_path", handle):
            pose = self.pose_in_path(frame)
            path.advance(pose)
            if check.is_reached(path, pose):
                return
            now_s = self.seconds()
            if progress.is_stuck(pose, now_s):
                text = "the robot does not get ahead"
                raise ControlError(_ERRORS.FAILED_TO_MAKE_PROGRESS, text)
            wanted = self.wanted_velocity(rules, check, path, pose)
            velocity = self.free_velocity(wanted)
            if velocity is not None:
                blocked_since = None
            elif blocked_since is None:
                blocked_since = now_s
            elif now_s - blocked_since > max(self.failure_s, 0.5):
                raise ControlError(_ERRORS.NO_VALID_CONTROL, "an obstacle is in the way")
            self.command(velocity or Velocity())
            self.tell(handle, path, pose)
            await ticker.next()

    def chosen(self, named: dict[str, Any], name: str) -> Any:
        """Return what a goal names, or the first if it names none."""
        if name and name not in named:
            known = ", ".join(named)
            text = f"there is no '{name}': there are {known}"
            raise ControlError(_ERRORS.INVALID_CONTROLLER, text)
        return named[name] if name else next(iter(named.values()))

    def pose_in_path(self, frame: str) -> Pose:
        """Return the pose of the robot in the frame of the path."""
        assert self.costmap is not None
        pose = self.frames.pose(frame, self.costmap.base_frame)
        if pose is None:
            text = f"the robot has no pose in the frame {frame}"
            raise ControlError(_ERRORS.TF_ERROR, text)
        return pose

    def wanted_velocity(
        self, rules: PursuitRules, check: GoalCheck, path: FollowedPath, pose: Pose
    ) -> Velocity:
        """Return the velocity that leads along the path."""
        if check.is_there:
            return rules.turn(turn_to(path.end.yaw - pose.yaw), self.last, self.period_s)
        points = path.ahead_of(pose)
        wanted = rules.follow(points, self.last, self.period_s)
        if self.points.get_subscription_count():
            self.publish_point(*ahead(points, rules.nearest_look_m))
        if wanted.forward > self.limit:
            share = self.limit / wanted.forward
            wanted = Velocity(self.limit, wanted.turn * share)
        return wanted

    def free_velocity(self, wanted: Velocity) -> Velocity | None:
        """Return the fastest velocity on the wanted arc with which the robot touches nothing.

        A robot that is too near to an obstacle already may drive away from it, slowly.
        """
        costmap = self.costmap
        assert costmap is not None
        pose = costmap.robot_pose()
        if pose is None or costmap.costs is None:
            return None
        velocity, poses = wanted, [pose]
        for share in _SLOWER:
            velocity = Velocity(wanted.forward * share, wanted.turn * share)
            poses = [pose @ step for step in arc(velocity, self.collision_s, 0.05)]
            if costmap.footprint.touches(poses, costmap.costs, costmap.geometry) is None:
                return velocity
        is_near = costmap.footprint.touches([pose], costmap.costs, costmap.geometry) is not None
        obstacles = costmap.costs == OBSTACLE
        is_better = is_near and leads_away(pose, poses[-1], obstacles, costmap.geometry)
        return velocity if is_better else None

    def command(self, velocity: Velocity) -> None:
        """Publish a velocity."""
        self.last = velocity
        self.velocities.publish(velocity.forward, velocity.turn)

    def tell(self, handle: Any, path: FollowedPath, pose: Pose) -> None:
        """Publish feedback."""
        feedback = FollowPath.Feedback()
        tracking = feedback.tracking_feedback
        tracking.remaining_path_length = path.left_m
        tracking.current_path_index = path.number
        tracking.position_tracking_error = float(np.hypot(*(path.points[path.number] - pose[:2])))
        handle.publish_feedback(feedback)

    def publish_point(self, x: float, y: float) -> None:
        """Publish the point ahead that the robot drives to."""
        assert self.costmap is not None
        message = PointStamped()
        message.header.frame_id, message.header.stamp = self.costmap.base_frame, self.stamp()
        message.point.x, message.point.y = x, y
        self.points.publish(message)


def main() -> None:
    """Run until Ctrl-C."""
    run_node(ControllerServer)


if __name__ == "__main__":
    main()
