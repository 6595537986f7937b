"""Requests to the planners of Nav2, which return paths and routes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.libraries.navigation.client import duration
from zbot.libraries.navigation.services import Nav2Services

from action_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped
from nav2_msgs import action
from nav_msgs.msg import Goals

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.libraries.navigation.client import Client

    from nav_msgs.msg import Path


class Nav2Planner(Nav2Services):
    """Node that asks for paths and routes, and waits for them."""

    def getPath(
        self, start: PoseStamped, goal: PoseStamped, planner_id: str = "", use_start: bool = False
    ) -> Path | None:
        """Return a path, or None. Without `use_start`, it begins where the robot is."""
        return self._path(self._getPathImpl(start, goal, planner_id, use_start))

    def _getPathImpl(
        self, start: PoseStamped, goal: PoseStamped, planner_id: str = "", use_start: bool = False
    ) -> Any:
        request = action.ComputePathToPose.Goal(
            start=start, goal=goal, planner_id=planner_id, use_start=use_start
        )
        return self._compute(self.compute_path_to_pose_client, request, "Get path")

    def getPathThroughPoses(
        self,
        start: PoseStamped,
        goals: Goals | Sequence[PoseStamped],
        planner_id: str = "",
        use_start: bool = False,
    ) -> Path | None:
        """Return a path through places, or None."""
        return self._path(self._getPathThroughPosesImpl(start, goals, planner_id, use_start))

    def _getPathThroughPosesImpl(
        self,
        start: PoseStamped,
        goals: Goals | Sequence[PoseStamped],
        planner_id: str = "",
        use_start: bool = False,
    ) -> Any:
        request = action.ComputePathThroughPoses.Goal(
            start=start,
            goals=goals if isinstance(goals, Goals) else self._goals(goals),
            planner_id=planner_id,
            use_start=use_start,
        )
        return self._compute(self.compute_path_through_poses_client, request, "Get path")

    def smoothPath(
        self,
        path: Path,
        smoother_id: str = "",
        max_duration: float = 2.0,
        check_for_collision: bool = False,
    ) -> Path | None:
        """Return a smoother path, or None. The server stops after `max_duration` seconds."""
        return self._path(
            self._smoothPathImpl(path, smoother_id, max_duration, check_for_collision)
        )

    def _smoothPathImpl(
        self,
        path: Path,
        smoother_id: str = "",
        max_duration: float = 2.0,
        check_for_collision: bool = False,
    ) -> Any:
        request = action.SmoothPath.Goal(
            path=path,
            smoother_id=smoother_id,
            max_smoothing_duration=duration(max_duration),
            check_for_collisions=check_for_collision,
        )
        return self._compute(self.smoother_client, request, "Smooth path")

    def getRoute(
        self, start: int | PoseStamped, goal: int | PoseStamped, use_start: bool = False
    ) -> list[Any] | None:
        """Return a list of a path and a route, or None. Places are poses or ids of the graph."""
        result = self._getRouteImpl(start, goal, use_start)
        return None if self._path(result) is None else [result.path, result.route]

    def _getRouteImpl(
        self, start: int | PoseStamped, goal: int | PoseStamped, use_start: bool = False
    ) -> Any:
        request = self._route_request(action.ComputeRoute, start, goal, use_start)
        if request is None:
            self.status = GoalStatus.STATUS_UNKNOWN
            return _failed(action.ComputeRoute.Result, self.last_action_error_msg)
        return self._compute(self.compute_route_client, request, "Get route")

    def _route_request(self, kind: Any, start: Any, goal: Any, use_start: bool) -> Any:
        if isinstance(start, int) and isinstance(goal, int):
            return kind.Goal(start_id=start, goal_id=goal, use_poses=False, use_start=use_start)
        if isinstance(start, PoseStamped) and isinstance(goal, PoseStamped):
            return kind.Goal(start=start, goal=goal, use_poses=True, use_start=use_start)
        self.setTaskError(kind.Result.UNKNOWN, "Request type fields were invalid!")
        self.error("Invalid start and goal types. Must be PoseStamped for pose or int for ID")
        return None

    def _compute(self, client: Client, goal: Any, what: str) -> Any:
        """Return the result of an action that computes something."""
        self.clearPreviousState()
        self.goal_handle = self._send(client, goal, f"{what}...")
        response = None
        if self.goal_handle is None:
            self.error(f"{what} was rejected!")
        else:
            future = self.goal_handle.get_result_async()
            self.result_future = future
            response = self._result_of(future)
        if response is None:
            self.status = GoalStatus.STATUS_UNKNOWN
            return _failed(client.action_type.Result, f"{what} was rejected!")
        self.status = response.status
        return response.result

    def _path(self, result: Any) -> Path | None:
        if self.status == GoalStatus.STATUS_SUCCEEDED:
            path: Path = result.path
            return path
        self.setTaskError(result.error_code, result.error_msg)
        self.warn(f"Getting path failed with {self._reason(result)}")
        return None

    def _goals(self, poses: Sequence[PoseStamped]) -> Goals:
        goals = Goals(goals=list(poses))
        goals.header.frame_id = "map"
        goals.header.stamp = self.get_clock().now().to_msg()
        return goals


def _failed(kind: Any, text: str) -> Any:
    return kind(error_code=kind.UNKNOWN, error_msg=text)
