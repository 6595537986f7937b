"""Services of a costmap: to read costs, and to forget obstacles."""

from __future__ import annotations

from typing import Any

from zbot_nodes.navigation.robot_frames import pose_in

from nav2_msgs.srv import (
    ClearCostmapAroundPose,
    ClearCostmapAroundRobot,
    ClearCostmapExceptRegion,
    ClearEntireCostmap,
    GetCostmap,
    GetCosts,
)

_UNKNOWN_COST = 255.0


class CostmapServices:
    """Services of one costmap.

    Args:
        costmap: The node `Costmap`.
    """

    def __init__(self, costmap: Any) -> None:
        self._costmap = costmap
        name = costmap.get_name()
        serve = costmap.create_service
        serve(GetCostmap, "get_costmap", self.get)
        serve(GetCosts, f"get_cost_{name}", self.get_costs)
        serve(ClearEntireCostmap, f"clear_entirely_{name}", self.clear)
        serve(ClearCostmapAroundRobot, f"clear_around_{name}", self.clear_around)
        serve(ClearCostmapExceptRegion, f"clear_except_{name}", self.clear_except)
        # nav2_simple_commander calls them by these names.
        serve(ClearCostmapAroundRobot, "clear_costmap_around_robot", self.clear_around)
        serve(ClearCostmapExceptRegion, "clear_costmap_except_region", self.clear_except)
        for service in (f"clear_around_pose_{name}", "clear_costmap_around_pose"):
            serve(ClearCostmapAroundPose, service, self.clear_around_pose)

    def get(self, _request: Any, response: Any) -> Any:
        """Answer with all costs."""
        response.map = self._costmap.message()
        return response

    def get_costs(self, request: Any, response: Any) -> Any:
        """Answer with the costs at places."""
        costmap = self._costmap
        for message in request.poses:
            pose = costmap.frames.moved(message, costmap.frame)
            cell = None if pose is None else costmap.geometry.cell(pose.x, pose.y)
            costs = costmap.costs
            cost = _UNKNOWN_COST if cell is None or costs is None else float(costs[cell])
            response.costs.append(cost)
        response.success = costmap.costs is not None
        return response

    def clear(self, _request: Any, response: Any) -> Any:
        """Forget all obstacles that scans have seen."""
        self._costmap.obstacles.cells[:] = False
        return self._done(response)

    def clear_around(self, request: Any, response: Any) -> Any:
        """Forget the obstacles around the robot."""
        return self._clear(self._costmap.robot_pose(), request, response, inside=True)

    def clear_except(self, request: Any, response: Any) -> Any:
        """Forget the obstacles that are not around the robot."""
        return self._clear(self._costmap.robot_pose(), request, response, inside=False)

    def clear_around_pose(self, request: Any, response: Any) -> Any:
        """Forget the obstacles around a place."""
        costmap = self._costmap
        frame = request.pose.header.frame_id
        pose = costmap.frames.moved(request.pose, costmap.frame) if frame else pose_in(request.pose)
        return self._clear(pose, request, response, inside=True)

    def _clear(self, pose: Any, request: Any, response: Any, *, inside: bool) -> Any:
        if pose is None:
            return response
        half_m = request.reset_distance / 2
        self._costmap.obstacles.clear(pose.x, pose.y, half_m, inside=inside)
        return self._done(response)

    def _done(self, response: Any) -> Any:
        self._costmap.update()
        response.success = True
        return response
