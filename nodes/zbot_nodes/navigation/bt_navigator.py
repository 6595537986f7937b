"""Send a robot to goals: plan, follow, and recover if something goes wrong.

Run:        zbot run nav2_bt_navigator bt_navigator, then configure and activate it
Actions:    navigate_to_pose, navigate_through_poses (nav2_msgs)
Uses:       compute_path_to_pose, compute_path_through_poses, follow_path, spin, backup, wait, and
            the services that clear costmaps
Subscribes: goal_pose (geometry_msgs/PoseStamped)
Try:        zbot topic pub --once /goal_pose geometry_msgs/msg/PoseStamped \
                "{header: {frame_id: map}, pose: {position: {x: 2.0}, orientation: {w: 1.0}}}"
"""

from __future__ import annotations

import math
from typing import Any

from zbot.time import Duration
from zbot_nodes.navigation.managed_server import ManagedServer, Ticker, end_goal
from zbot_nodes.navigation.remote_actions import RemoteActions, RemoteError, cancel
from zbot_nodes.navigation.robot_frames import pose_message
from zbot_nodes.navigation.trip import Trip
from zbot_nodes.robot.pose import Pose
from zbot_nodes.startup.program import run_node

from geometry_msgs.msg import Point, PoseStamped
from nav2_msgs.action import (
    BackUp,
    ComputePathThroughPoses,
    ComputePathToPose,
    FollowPath,
    NavigateThroughPoses,
    NavigateToPose,
    Spin,
    Wait,
)
from nav2_msgs.srv import ClearEntireCostmap

_ACTIONS = {
    "compute_path_to_pose": ComputePathToPose,
    "compute_path_through_poses": ComputePathThroughPoses,
    "follow_path": FollowPath,
    "spin": Spin,
    "backup": BackUp,
    "wait": Wait,
    "navigate_to_pose": NavigateToPose,
}
_COSTMAPS = ("global_costmap", "local_costmap")
_PERIOD_S = 0.1
_REPLAN_S = 1.0
_ENOUGH_M = 0.6  # so near to the goal, there is no new plan
_MOST_RECOVERIES = 6
#: Errors that no recovery mends.
_HOPELESS = (
    *(ComputePathToPose.Result.GOAL_OUTSIDE_MAP, ComputePathToPose.Result.INVALID_PLANNER),
    *(ComputePathThroughPoses.Result.GOAL_OUTSIDE_MAP, FollowPath.Result.INVALID_CONTROLLER),
    ComputePathThroughPoses.Result.NO_VIAPOINTS_GIVEN,
)


def _seconds(seconds: float) -> Any:
    return Duration(seconds=seconds).to_msg()


#: What the robot does after the costmaps were cleared, one after the other.
_RECOVERIES: tuple[tuple[str, Any], ...] = (
    ("wait", Wait.Goal(time=_seconds(1.0))),
    ("spin", Spin.Goal(target_yaw=math.pi / 2, time_allowance=_seconds(10.0))),
    ("backup", BackUp.Goal(target=Point(x=-0.3), speed=0.1, time_allowance=_seconds(10.0))),
    ("wait", Wait.Goal(time=_seconds(5.0))),
)


class BtNavigator(ManagedServer):
    """Leads the robot to one goal, or through several ones.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__("bt_navigator", **options)

    def configure(self) -> None:
        """Create the clients and the actions."""
        settings = self.settings
        self.map_frame = settings.text("global_frame", "map")
        self.base_frame = settings.text("robot_base_frame", "base_link")
        self.period_s = max(settings.number("bt_loop_duration", 10.0) / 1000, _PERIOD_S)
        for name in settings.texts("navigators", ["navigate_to_pose", "navigate_through_poses"]):
            settings.text(f"{name}.plugin", "")
        self.remote = RemoteActions(self, _ACTIONS)
        self.clearing = [
            self.create_client(
                ClearEntireCostmap, f"{name}/clear_entirely_{name}", callback_group=self.group
            )
            for name in _COSTMAPS
        ]
        self.goals = self.create_subscription(
            PoseStamped, "goal_pose", self.take_goal, 10, callback_group=self.group
        )
        self.create_action(NavigateToPose, "navigate_to_pose", self.to_pose)
        self.create_action(NavigateThroughPoses, "navigate_through_poses", self.through_poses)

    def clean_up(self) -> None:
        """Destroy the clients."""
        self.remote.close()
        self.destroy_subscription(self.goals)
        for client in self.clearing:
            self.destroy_client(client)

    async def take_goal(self, message: PoseStamped) -> None:
        """Go to the goal of a topic."""
        try:
            await self.remote.start("navigate_to_pose", NavigateToPose.Goal(pose=message))
        except RemoteError as error:
            self.get_logger().error(str(error))

    async def to_pose(self, handle: Any) -> Any:
        """Go to a pose."""
        goals = [handle.request.pose]
        return await self.go("navigate_to_pose", handle, NavigateToPose, goals)

    async def through_poses(self, handle: Any) -> Any:
        """Go through poses to the last one."""
        goals = list(handle.request.poses.goals)
        return await self.go("navigate_through_poses", handle, NavigateThroughPoses, goals)

    async def go(self, name: str, handle: Any, kind: Any, goals: list[Any]) -> Any:
        """Lead the robot to its goals, and end the goal of the action."""
        trip, ticker = Trip(goals, self.seconds()), Ticker(self, self.period_s)
        if handle.request.behavior_tree:
            self.get_logger().info("The behavior tree of the goal is not read", once=True)
        code, text = 0, ""
        try:
            while self.is_wanted(name, handle) and not await self.advance(trip):
                self.tell(handle, kind, trip)
                await ticker.next()
        except RemoteError as error:
            code, text = error.code or kind.Result.UNKNOWN, str(error)
        finally:
            ticker.close()
            await cancel(trip.following)
        if not code and not self.is_newest(name, handle):
            code, text = kind.Result.UNKNOWN, "a newer goal came"
            self.get_logger().info("A newer goal replaces the goal")
        elif code:
            self.get_logger().error(f"Goal failed: {text}")
        elif not handle.is_cancel_requested:
            self.get_logger().info("Goal succeeded")
        return end_goal(handle, kind.Result(), code, text)

    async def advance(self, trip: Trip) -> bool:
        """Do what is due. Return whether the robot is at its last goal.

        Raises:
            RemoteError: The goal cannot be reached.
        """
        try:
            self.note_pose(trip)
            if self.is_plan_due(trip):
                await self.plan(trip)
            following = trip.following
            if following is None or not following.is_over:
                return False
            following.result()
        except RemoteError as error:
            await self.recover(trip, error)
            return False
        return True

    def note_pose(self, trip: Trip) -> None:
        """Note where the robot is."""
        pose = self.frames.pose(self.map_frame, self.base_frame)
        if pose is None:
            text = f"the robot has no pose in the frame {self.map_frame}"
            raise RemoteError(NavigateToPose.Result.TF_ERROR, text)
        trip.move(pose, [self.frames.moved(goal, self.map_frame) for goal in trip.goals])

    def is_plan_due(self, trip: Trip) -> bool:
        """Return whether the trip needs a new plan."""
        if trip.following is None:
            return True
        is_old = self.seconds() - trip.planned_s >= _REPLAN_S
        return is_old and not trip.following.is_over and trip.left_m() > _ENOUGH_M

    async def plan(self, trip: Trip) -> None:
        """Plan a path, and let the controller follow it."""
        trip.planned_s = self.seconds()
        try:
            path = await self.path_of(trip)
        except RemoteError:
            if trip.following is None:
                raise
            return  # the controller stops if the path that it has is blocked
        trip.path = path
        trip.following = await self.remote.start("follow_path", FollowPath.Goal(path=path))

    async def path_of(self, trip: Trip) -> Any:
        """Return a path to the goals."""
        if len(trip.goals) == 1:
            goal = ComputePathToPose.Goal(goal=trip.goals[0])
            return (await self.remote.run("compute_path_to_pose", goal)).path
        through = ComputePathThroughPoses.Goal()
        through.goals.goals = trip.goals
        return (await self.remote.run("compute_path_through_poses", through)).path

    async def recover(self, trip: Trip, error: RemoteError) -> None:
        """Clear the costmaps, and move a little, so that another try may succeed.

        Raises:
            RemoteError: There were enough tries. It is the error of the last one.
        """
        await cancel(trip.following)
        if error.code in _HOPELESS or trip.recoveries >= _MOST_RECOVERIES:
            raise error
        name, goal = _RECOVERIES[trip.recoveries % len(_RECOVERIES)]
        trip.recoveries += 1
        trip.following = None
        self.get_logger().warning(f"{error}: clearing the costmaps, then {name}")
        for client in self.clearing:
            if client.service_is_ready():
                await client.call_async(ClearEntireCostmap.Request())
        try:
            await self.remote.run(name, goal)
        except RemoteError as failure:
            self.get_logger().warning(f"{name} failed: {failure}")

    def tell(self, handle: Any, kind: Any, trip: Trip) -> None:
        """Publish feedback."""
        feedback = kind.Feedback()
        trip.fill(feedback, self.seconds())
        pose = self.frames.pose(self.map_frame, self.base_frame) or Pose()
        feedback.current_pose = pose_message(pose, self.map_frame, self.stamp())
        if kind is NavigateThroughPoses:
            feedback.number_of_poses_remaining = len(trip.goals)
        handle.publish_feedback(feedback)


def main() -> None:
    """Run until Ctrl-C."""
    run_node(BtNavigator)


if __name__ == "__main__":
    main()
