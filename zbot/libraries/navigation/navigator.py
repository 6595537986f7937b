"""Client of Nav2: `BasicNavigator` of ROS 2's package `nav2_simple_commander`."""

from __future__ import annotations

from enum import Enum
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.libraries.navigation.client import duration
from zbot.libraries.navigation.planner import Nav2Planner
from zbot.runtime import spin_until_future_complete

from action_msgs.msg import GoalStatus
from geometry_msgs.msg import Point, PoseStamped
from nav2_msgs import action
from nav_msgs.msg import Goals

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.executor.task import Future
    from zbot.libraries.navigation.client import Client

    from geographic_msgs.msg import GeoPose
    from nav_msgs.msg import Path

_CHECK_S = 0.1  # how long `isTaskComplete` waits for the result


class TaskResult(Enum):
    """How a task ended."""

    UNKNOWN = 0
    SUCCEEDED = 1
    CANCELED = 2
    FAILED = 3


class RunningTask(Enum):
    """Task that a method of the navigator started."""

    NONE = 0
    NAVIGATE_TO_POSE = 1
    NAVIGATE_THROUGH_POSES = 2
    FOLLOW_PATH = 3
    FOLLOW_WAYPOINTS = 4
    FOLLOW_GPS_WAYPOINTS = 5
    SPIN = 6
    BACKUP = 7
    DRIVE_ON_HEADING = 8
    ASSISTED_TELEOP = 9
    DOCK_ROBOT = 10
    UNDOCK_ROBOT = 11
    COMPUTE_AND_TRACK_ROUTE = 12
    FOLLOW_OBJECT = 13


class BasicNavigator(Nav2Planner):
    """Node that sends a robot with Nav2 to places, one task at a time.

    Each method that starts a task waits until its action server is there and has accepted the goal.
    It returns the task, or `None` if the server refused the goal. Then `isTaskComplete` is called
    until it is true, and `getResult` tells how the task ended. No other thread may spin the node.

    Args:
        node_name: The name of the node.
        namespace: The namespace of the node, and of the names of Nav2.
    """

    def __init__(self, node_name: str = "basic_navigator", namespace: str = "") -> None:
        super().__init__(node_name, namespace)
        # A route is tracked while another task runs, and none of its feedback may be lost.
        self.route_goal_handle: Any = None
        self.route_result_future: Future[Any] | None = None
        self.route_feedback: list[Any] = []

    # -- tasks ---------------------------------------------------------------------------------

    def goToPose(self, pose: PoseStamped, behavior_tree: str = "") -> RunningTask | None:
        """Drive to a place. `behavior_tree` is a file of the robot; empty means its default."""
        goal = action.NavigateToPose.Goal(pose=pose, behavior_tree=behavior_tree)
        place = f"{pose.pose.position.x} {pose.pose.position.y}"
        return self._start(
            self.nav_to_pose_client,
            goal,
            RunningTask.NAVIGATE_TO_POSE,
            f"Navigating to goal: {place}...",
        )

    def goThroughPoses(
        self, poses: Goals | Sequence[PoseStamped], behavior_tree: str = ""
    ) -> RunningTask | None:
        """Drive through places to the last of them. A list is accepted as in ROS 2 Jazzy."""
        goals = poses if isinstance(poses, Goals) else self._goals(poses)
        goal = action.NavigateThroughPoses.Goal(poses=goals, behavior_tree=behavior_tree)
        count = len(goals.goals)
        return self._start(
            self.nav_through_poses_client,
            goal,
            RunningTask.NAVIGATE_THROUGH_POSES,
            f"Navigating with {count} goals....",
        )

    def followWaypoints(
        self, poses: Sequence[PoseStamped], number_of_loops: int = 0, goal_index: int = 0
    ) -> RunningTask | None:
        """Drive to each place and stop there, `number_of_loops` more times."""
        goal = action.FollowWaypoints.Goal(
            poses=list(poses), number_of_loops=number_of_loops, goal_index=goal_index
        )
        return self._start(
            self.follow_waypoints_client,
            goal,
            RunningTask.FOLLOW_WAYPOINTS,
            f"Following {len(goal.poses)} goals....",
        )

    def followGpsWaypoints(self, gps_poses: Sequence[GeoPose]) -> RunningTask | None:
        """Drive to places on the earth, one after the other."""
        goal = action.FollowGPSWaypoints.Goal(gps_poses=list(gps_poses))
        return self._start(
            self.follow_gps_waypoints_client,
            goal,
            RunningTask.FOLLOW_GPS_WAYPOINTS,
            f"Following {len(goal.gps_poses)} gps goals....",
        )

    def spin(
        self,
        spin_dist: float = 1.57,
        time_allowance: float = 10,
        disable_collision_checks: bool = False,
    ) -> RunningTask | None:
        """Turn on the spot by `spin_dist` radians within `time_allowance` seconds."""
        goal = action.Spin.Goal(
            target_yaw=float(spin_dist),
            time_allowance=duration(time_allowance),
            disable_collision_checks=disable_collision_checks,
        )
        return self._start(
            self.spin_client, goal, RunningTask.SPIN, f"Spinning to angle {goal.target_yaw}...."
        )

    def backup(
        self,
        backup_dist: float = 0.15,
        backup_speed: float = 0.025,
        time_allowance: float = 10,
        disable_collision_checks: bool = False,
    ) -> RunningTask | None:
        """Drive back by `backup_dist` metres at `backup_speed` m/s."""
        goal = action.BackUp.Goal(
            target=Point(x=float(backup_dist)),
            speed=float(backup_speed),
            time_allowance=duration(time_allowance),
            disable_collision_checks=disable_collision_checks,
        )
        return self._start(
            self.backup_client,
            goal,
            RunningTask.BACKUP,
            f"Backing up {goal.target.x} m at {goal.speed} m/s....",
        )

    def driveOnHeading(
        self,
        dist: float = 0.15,
        speed: float = 0.025,
        time_allowance: float = 10,
        disable_collision_checks: bool = False,
    ) -> RunningTask | None:
        """Drive straight by `dist` metres at `speed` m/s."""
        goal = action.DriveOnHeading.Goal(
            target=Point(x=float(dist)),
            speed=float(speed),
            time_allowance=duration(time_allowance),
            disable_collision_checks=disable_collision_checks,
        )
        return self._start(
            self.drive_on_heading_client,
            goal,
            RunningTask.DRIVE_ON_HEADING,
            f"Drive {goal.target.x} m on heading at {goal.speed} m/s....",
        )

    def assistedTeleop(self, time_allowance: float = 30) -> RunningTask | None:
        """Let a person drive for `time_allowance` seconds, and stop before obstacles."""
        goal = action.AssistedTeleop.Goal(time_allowance=duration(time_allowance))
        return self._start(
            self.assisted_teleop_client,
            goal,
            RunningTask.ASSISTED_TELEOP,
            "Running 'assisted_teleop'....",
        )

    def followPath(
        self,
        path: Path,
        controller_id: str = "",
        goal_checker_id: str = "",
        progress_checker_id: str = "",
        path_handler_id: str = "",
    ) -> RunningTask | None:
        """Drive along a path. The names are those of Nav2's plugins; empty means the default."""
        goal = action.FollowPath.Goal(
            path=path,
            controller_id=controller_id,
            goal_checker_id=goal_checker_id,
            progress_checker_id=progress_checker_id,
            path_handler_id=path_handler_id,
        )
        return self._start(
            self.follow_path_client, goal, RunningTask.FOLLOW_PATH, "Executing path..."
        )

    def dockRobotByPose(
        self, dock_pose: PoseStamped, dock_type: str = "", nav_to_dock: bool = True
    ) -> RunningTask | None:
        """Drive into a dock at a place. `nav_to_dock` means: first drive to its staging pose."""
        goal = action.DockRobot.Goal(
            use_dock_id=False,
            dock_pose=dock_pose,
            dock_type=dock_type,
            navigate_to_staging_pose=nav_to_dock,
        )
        text = f"Docking at pose: {dock_pose}..."
        return self._start(self.docking_client, goal, RunningTask.DOCK_ROBOT, text)

    def dockRobotByID(self, dock_id: str, nav_to_dock: bool = True) -> RunningTask | None:
        """Drive into a dock that Nav2 knows by its name."""
        goal = action.DockRobot.Goal(
            use_dock_id=True, dock_id=dock_id, navigate_to_staging_pose=nav_to_dock
        )
        text = f"Docking at dock ID: {dock_id}..."
        return self._start(self.docking_client, goal, RunningTask.DOCK_ROBOT, text)

    def undockRobot(self, dock_type: str = "") -> RunningTask | None:
        """Leave the dock."""
        goal = action.UndockRobot.Goal(dock_type=dock_type)
        text = f"Undocking from dock of type: {dock_type}..."
        return self._start(self.undocking_client, goal, RunningTask.UNDOCK_ROBOT, text)

    def followObjectByTopic(self, topic: str, max_duration: float = 0) -> RunningTask | None:
        """Follow the object whose pose is on a topic. 0 seconds mean: without end."""
        goal = action.FollowObject.Goal(pose_topic=topic, max_duration=duration(max_duration))
        text = f"Following object on topic: {topic}..."
        return self._start(self.following_client, goal, RunningTask.FOLLOW_OBJECT, text)

    def followObjectByFrame(self, frame: str, max_duration: float = 0) -> RunningTask | None:
        """Follow an object that is a frame of the transforms. 0 seconds mean: without end."""
        goal = action.FollowObject.Goal(tracked_frame=frame, max_duration=duration(max_duration))
        text = f"Following object in frame: {frame}..."
        return self._start(self.following_client, goal, RunningTask.FOLLOW_OBJECT, text)

    def getAndTrackRoute(
        self, start: int | PoseStamped, goal: int | PoseStamped, use_start: bool = False
    ) -> RunningTask | None:
        """Compute a route, and report the progress of the robot on it. It may run beside a task."""
        request = self._route_request(action.ComputeAndTrackRoute, start, goal, use_start)
        if request is None:
            return None
        client, task = self.compute_and_track_route_client, RunningTask.COMPUTE_AND_TRACK_ROUTE
        return self._start(client, request, task, "Computing and tracking route...")

    # -- the running task ----------------------------------------------------------------------

    def _start(self, client: Client, goal: Any, task: RunningTask, text: str) -> RunningTask | None:
        is_route = task is RunningTask.COMPUTE_AND_TRACK_ROUTE
        callback = self._routeFeedbackCallback if is_route else self._feedbackCallback
        self.clearPreviousState()
        handle = self._send(client, goal, text, callback)
        if handle is None:
            refusal = f"{client.action_type.__name__} request was rejected!"
            self.setTaskError(client.action_type.Result.UNKNOWN, refusal)
            self.error(refusal)
        if is_route:
            self.route_goal_handle = handle
            self.route_result_future = None if handle is None else handle.get_result_async()
        else:
            self.goal_handle = handle
            self.result_future = None if handle is None else handle.get_result_async()
        return None if handle is None else task

    def cancelTask(self) -> None:
        """Ask the servers to cancel the task and the route."""
        self.info("Canceling current task.")
        for future, handle in (
            (self.result_future, self.goal_handle),
            (self.route_result_future, self.route_goal_handle),
        ):
            if future is not None and handle is not None:
                self._result_of(handle.cancel_goal_async())
        self.clearPreviousState()

    def isTaskComplete(self, task: RunningTask | None = RunningTask.NONE) -> bool:
        """Spin up to 0.1 s, and return whether the task has ended.

        Args:
            task: What the method that started the task returned. Without it, the last task that is
                not a route.
        """
        if task is None:
            self.error("Task is None, cannot check for completion")
            return False
        is_route = task is RunningTask.COMPUTE_AND_TRACK_ROUTE
        future = self.route_result_future if is_route else self.result_future
        if future is None:
            return True
        spin_until_future_complete(self, future, timeout_sec=_CHECK_S)
        if not future.done():
            return False
        try:
            self._finish(future.result())
        except ZbotError as error:  # the server has ended
            self.status = GoalStatus.STATUS_UNKNOWN
            self.setTaskError(0, str(error))
        return True

    def _finish(self, response: Any) -> None:
        self.status = response.status
        if response.status != GoalStatus.STATUS_SUCCEEDED:
            self.setTaskError(response.result.error_code, response.result.error_msg)
            self.debug(f"Task failed with {self._reason(response.result)}")
        else:
            self.debug("Task succeeded!")

    def getFeedback(self, task: RunningTask = RunningTask.NONE) -> Any:
        """Return the last feedback of the task, or the next feedback of a route. May be None."""
        if task is not RunningTask.COMPUTE_AND_TRACK_ROUTE:
            return self.feedback
        return self.route_feedback.pop(0) if self.route_feedback else None

    def getResult(self) -> TaskResult:
        """Return how the last task ended."""
        return {
            GoalStatus.STATUS_SUCCEEDED: TaskResult.SUCCEEDED,
            GoalStatus.STATUS_ABORTED: TaskResult.FAILED,
            GoalStatus.STATUS_CANCELED: TaskResult.CANCELED,
        }.get(self.status or 0, TaskResult.UNKNOWN)

    # -- feedback ------------------------------------------------------------------------------

    def _feedbackCallback(self, msg: Any) -> None:
        self.debug("Received action feedback message")
        self.feedback = msg.feedback

    def _routeFeedbackCallback(self, msg: Any) -> None:
        self.debug("Received route action feedback message")
        self.route_feedback.append(msg.feedback)
