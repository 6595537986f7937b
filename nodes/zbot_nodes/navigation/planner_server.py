"""Plan paths through a map, on request.

Run:        zbot run nav2_planner planner_server, then configure and activate it
Actions:    compute_path_to_pose (nav2_msgs/ComputePathToPose),
            compute_path_through_poses (nav2_msgs/ComputePathThroughPoses)
Publishes:  plan (nav_msgs/Path); and what its costmap publishes, in global_costmap/
Serves:     is_path_valid (nav2_msgs/IsPathValid)
"""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

from zbot.time import Duration
from zbot_nodes.navigation.costmap import Costmap
from zbot_nodes.navigation.grids import np
from zbot_nodes.navigation.grids.costs import NO_INFORMATION, TOUCHING
from zbot_nodes.navigation.grids.path import cost_at, headings, smooth
from zbot_nodes.navigation.grids.path_search import find_path
from zbot_nodes.navigation.managed_server import ManagedServer, end_goal
from zbot_nodes.navigation.robot_frames import pose_in, pose_message
from zbot_nodes.robot.pose import Pose
from zbot_nodes.startup.program import run_node

from nav2_msgs.action import ComputePathThroughPoses, ComputePathToPose
from nav2_msgs.srv import IsPathValid
from nav_msgs.msg import Path

if TYPE_CHECKING:
    from numpy.typing import NDArray

_ERRORS = ComputePathToPose.Result
_DEFAULT_PLANNERS = ["GridBased"]


class PlanningError(Exception):
    """There is no path.

    Args:
        name: The name of the error code, which both actions have.
        text: What is wrong.
    """

    def __init__(self, name: str, text: str) -> None:
        self.name = name
        super().__init__(text)


class PlannerServer(ManagedServer):
    """Searches the cheapest path in the global costmap.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__("planner_server", **options)
        self.costmap: Costmap | None = None

    def configure(self) -> None:
        """Create the costmap and the actions."""
        settings = self.settings
        self.planners = settings.texts("planner_plugins", _DEFAULT_PLANNERS)
        first = self.planners[0]
        settings.text(f"{first}.plugin", "nav2_navfn_planner::NavfnPlanner")
        settings.flag(f"{first}.use_astar", default=True)
        self.tolerance_m = settings.number(f"{first}.tolerance", 0.5)
        self.allow_unknown = settings.flag(f"{first}.allow_unknown", default=True)
        self.costmap = Costmap("global_costmap", self, is_rolling=False)
        if self.executor is not None:
            self.executor.add_node(self.costmap)
        self.publisher = self.create_publisher(Path, "plan", 10)
        self.service = self.create_service(IsPathValid, "is_path_valid", self.check)
        self.create_action(ComputePathToPose, "compute_path_to_pose", self.plan_to_pose)
        self.create_action(
            ComputePathThroughPoses, "compute_path_through_poses", self.plan_through_poses
        )

    def clean_up(self) -> None:
        """Destroy the costmap."""
        self.destroy_publisher(self.publisher)
        self.destroy_service(self.service)
        if self.costmap is not None:
            self.costmap.destroy_node()
        self.costmap = None

    def plan_to_pose(self, handle: Any) -> Any:
        """Plan a path to a pose, through its via points."""
        goal = handle.request
        return self.answer(handle, ComputePathToPose.Result(), [*goal.viapoints, goal.goal])

    def plan_through_poses(self, handle: Any) -> Any:
        """Plan a path through poses."""
        result = ComputePathThroughPoses.Result()
        result.last_reached_index = len(handle.request.goals.goals) - 1
        return self.answer(handle, result, list(handle.request.goals.goals))

    def answer(self, handle: Any, result: Any, goals: list[Any]) -> Any:
        """Plan, and end the goal of the action."""
        goal, begin = handle.request, time.monotonic()
        try:
            self.check_goal(goal.planner_id, goals)
            result.path = self.plan(goals, goal.start if goal.use_start else None)
        except PlanningError as error:
            self.get_logger().warning(str(error))
            code = getattr(type(result), error.name, type(result).UNKNOWN)
            return end_goal(handle, result, code, str(error))
        self.publisher.publish(result.path)
        result.planning_time = Duration(seconds=time.monotonic() - begin).to_msg()
        return end_goal(handle, result)

    def check_goal(self, planner: str, goals: list[Any]) -> None:
        """Check the planner and the poses of a goal.

        Raises:
            PlanningError: There is no such planner, or there are no poses.
        """
        if planner and planner not in self.planners:
            text = f"there is no planner {planner}: there are {', '.join(self.planners)}"
            raise PlanningError("INVALID_PLANNER", text)
        if not goals:
            raise PlanningError("NO_VIAPOINTS_GIVEN", "no poses are given")

    def plan(self, goals: list[Any], start: Any) -> Path:
        """Return the path through poses.

        Args:
            goals: Poses with their frames.
            start: Where it begins. None means where the robot is.

        Raises:
            PlanningError: There is no such path.
        """
        costmap = self.costmap
        if costmap is None or costmap.costs is None:
            raise PlanningError("UNKNOWN", "there is no map yet")
        at = costmap.robot_pose() if start is None else self.frames.moved(start, costmap.frame)
        poses = [self.frames.moved(goal, costmap.frame) for goal in goals]
        if at is None or None in poses:
            raise PlanningError("TF_ERROR", "the robot or the goal has no pose in the map")
        stamp, path = self.stamp(), Path()
        path.header.frame_id, path.header.stamp = costmap.frame, stamp
        for pose in poses:
            assert pose is not None
            points = self.leg(at, pose)
            turns = np.append(headings(points)[:-1], pose.yaw)
            for (x, y), yaw in zip(points.tolist(), turns.tolist(), strict=True):
                path.poses.append(pose_message(Pose(x, y, yaw), costmap.frame, stamp))
            at = pose
        return path

    def leg(self, start: Pose, goal: Pose) -> NDArray[np.float64]:
        """Return the points of the path between two poses."""
        costmap = self.costmap
        assert costmap is not None
        assert costmap.costs is not None
        geometry, costs = costmap.geometry, costmap.costs
        first, last = geometry.cell(start.x, start.y), geometry.cell(goal.x, goal.y)
        if first is None:
            raise PlanningError("START_OUTSIDE_MAP", f"the start {_text(start)} is not in the map")
        if last is None:
            raise PlanningError("GOAL_OUTSIDE_MAP", f"the goal {_text(goal)} is not in the map")
        cells = find_path(
            costs,
            first,
            last,
            allow_unknown=self.allow_unknown,
            tolerance=self.tolerance_m / geometry.resolution,
        )
        if cells is None:
            is_blocked = TOUCHING <= costs[last] < NO_INFORMATION
            name = "GOAL_OCCUPIED" if is_blocked else "NO_VALID_PATH"
            raise PlanningError(name, f"there is no path from {_text(start)} to {_text(goal)}")
        points = geometry.centres(*np.array(cells).T)
        points[0] = start.x, start.y
        if cells[-1] == last:
            points = (
                np.vstack([points[:-1], [[goal.x, goal.y]]])
                if len(points) > 1
                else (np.array([[start.x, start.y], [goal.x, goal.y]]))
            )
        return smooth(points, costs, geometry)

    def check(self, request: Any, response: Any) -> Any:
        """Answer whether a path is free, from the point that is nearest to the robot."""
        costmap = self.costmap
        response.success = costmap is not None and costmap.costs is not None
        if costmap is None or costmap.costs is None or not request.path.poses:
            return response
        points = np.array([pose_in(pose)[:2] for pose in request.path.poses])
        costs = cost_at(points, costmap.costs, costmap.geometry)
        at = costmap.robot_pose()
        begin = 0 if at is None else int(np.hypot(*(points - at[:2]).T).argmin())
        limit = min(request.max_cost, TOUCHING)
        blocked = np.flatnonzero(costs[begin:] >= limit) + begin
        response.is_valid = not len(blocked)
        response.invalid_pose_indices = blocked.tolist()
        return response


def _text(pose: Pose) -> str:
    return f"({pose.x:.2f}, {pose.y:.2f})"


def main() -> None:
    """Run until Ctrl-C."""
    run_node(PlannerServer)


if __name__ == "__main__":
    main()
