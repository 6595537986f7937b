"""Take the corners off paths, on request.

Run:        zbot run nav2_smoother smoother_server, then configure and activate it
Action:     smooth_path (nav2_msgs/SmoothPath)
Subscribes: global_costmap/costmap_raw (nav2_msgs/Costmap)
Publishes:  plan_smoothed (nav_msgs/Path)
"""

from __future__ import annotations

from typing import Any

from zbot.qos import DurabilityPolicy, QoSProfile
from zbot_nodes.navigation.grids import np
from zbot_nodes.navigation.grids.costs import TOUCHING
from zbot_nodes.navigation.grids.geometry import GridGeometry
from zbot_nodes.navigation.grids.path import cost_at, headings, smooth
from zbot_nodes.navigation.managed_server import ManagedServer, end_goal
from zbot_nodes.navigation.robot_frames import pose_in, pose_message
from zbot_nodes.robot.pose import Pose
from zbot_nodes.startup.program import run_node

from nav2_msgs.action import SmoothPath
from nav2_msgs.msg import Costmap
from nav_msgs.msg import Path

_KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
_ERRORS = SmoothPath.Result
_LEAST_POSES = 3


class SmootherServer(ManagedServer):
    """Smooths one path at a time.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__("smoother_server", **options)
        self.costs: Any = np.zeros((0, 0), np.uint8)
        self.geometry = GridGeometry(0.0, 0.0, 0.05, 0, 0)

    def configure(self) -> None:
        """Create the topics and the action."""
        self.names = self.settings.texts("smoother_plugins", ["simple_smoother"])
        for name in self.names:
            self.settings.text(f"{name}.plugin", "nav2_smoother::SimpleSmoother")
        topic = self.settings.text("costmap_topic", "global_costmap/costmap_raw")
        self.costmaps = self.create_subscription(Costmap, topic, self.take_costmap, _KEPT)
        self.publisher = self.create_publisher(Path, "plan_smoothed", 10)
        self.create_action(SmoothPath, "smooth_path", self.smooth)

    def clean_up(self) -> None:
        """Destroy the topics."""
        self.destroy_subscription(self.costmaps)
        self.destroy_publisher(self.publisher)

    def take_costmap(self, message: Costmap) -> None:
        """Store the costs."""
        data = message.metadata
        if len(message.data) != data.size_x * data.size_y or not data.resolution > 0:
            return
        corner = data.origin.position
        self.geometry = GridGeometry(corner.x, corner.y, data.resolution, data.size_y, data.size_x)
        self.costs = np.array(memoryview(message.data)).reshape(self.geometry.shape)

    def smooth(self, handle: Any) -> Any:
        """Smooth the path of a goal."""
        goal, result = handle.request, SmoothPath.Result()
        result.path = goal.path
        if goal.smoother_id and goal.smoother_id not in self.names:
            text = f"there is no smoother {goal.smoother_id}: there are {', '.join(self.names)}"
            return end_goal(handle, result, _ERRORS.INVALID_SMOOTHER, text)
        if len(goal.path.poses) < _LEAST_POSES:
            result.was_completed = True
            return end_goal(handle, result)
        points = np.array([pose_in(pose)[:2] for pose in goal.path.poses])
        points = smooth(points, self.costs, self.geometry)
        touches = cost_at(points, self.costs, self.geometry) >= TOUCHING
        if goal.check_for_collisions and touches.any():
            text = "the smooth path touches an obstacle"
            return end_goal(handle, result, _ERRORS.SMOOTHED_PATH_IN_COLLISION, text)
        result.path, result.was_completed = self.path(goal.path, points), True
        self.publisher.publish(result.path)
        return end_goal(handle, result)

    def path(self, old: Path, points: Any) -> Path:
        """Return a path through points that ends as an old one."""
        frame, stamp = old.header.frame_id, self.stamp()
        path = Path(header=old.header)
        turns = np.append(headings(points)[:-1], pose_in(old.poses[-1]).yaw)
        for (x, y), yaw in zip(points.tolist(), turns.tolist(), strict=True):
            path.poses.append(pose_message(Pose(x, y, yaw), frame, stamp))
        return path


def main() -> None:
    """Run until Ctrl-C."""
    run_node(SmootherServer)


if __name__ == "__main__":
    main()
