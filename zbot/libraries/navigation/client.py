"""Node with the action clients and service clients of Nav2."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeAlias

from zbot.action import ActionClient
from zbot.errors import ZbotError
from zbot.node.node import Node
from zbot.runtime import spin_until_future_complete
from zbot.time import Duration

from geometry_msgs.msg import PoseStamped
from nav2_msgs import action, srv

if TYPE_CHECKING:
    from zbot.executor.task import Future

_WAIT_S = 1.0  # between two log lines that something is not available

Client: TypeAlias = ActionClient[Any, Any, Any]


class Nav2Client(Node):
    """Node that sends goals and requests to Nav2. It spins while it waits for the answers."""

    def __init__(self, node_name: str, namespace: str = "") -> None:
        super().__init__(node_name, namespace=namespace)
        self.initial_pose = PoseStamped()
        self.initial_pose.header.frame_id = "map"
        self.initial_pose_received = False
        self.goal_handle: Any = None
        self.result_future: Future[Any] | None = None
        self.feedback: Any = None
        self.status: int | None = None  #: of the last goal, a constant of `GoalStatus`
        self.last_action_error_code = 0
        self.last_action_error_msg = ""
        self._create_action_clients()
        self._create_service_clients()

    def _create_action_clients(self) -> None:
        def client(kind: type[Any], name: str) -> Client:
            return ActionClient(self, kind, name)

        self.nav_to_pose_client = client(action.NavigateToPose, "navigate_to_pose")
        self.nav_through_poses_client = client(
            action.NavigateThroughPoses, "navigate_through_poses"
        )
        self.follow_waypoints_client = client(action.FollowWaypoints, "follow_waypoints")
        self.follow_gps_waypoints_client = client(action.FollowGPSWaypoints, "follow_gps_waypoints")
        self.follow_path_client = client(action.FollowPath, "follow_path")
        self.compute_path_to_pose_client = client(action.ComputePathToPose, "compute_path_to_pose")
        self.compute_path_through_poses_client = client(
            action.ComputePathThroughPoses, "compute_path_through_poses"
        )
        self.smoother_client = client(action.SmoothPath, "smooth_path")
        self.compute_route_client = client(action.ComputeRoute, "compute_route")
        self.compute_and_track_route_client = client(
            action.ComputeAndTrackRoute, "compute_and_track_route"
        )
        self.spin_client = client(action.Spin, "spin")
        self.backup_client = client(action.BackUp, "backup")
        self.drive_on_heading_client = client(action.DriveOnHeading, "drive_on_heading")
        self.assisted_teleop_client = client(action.AssistedTeleop, "assisted_teleop")
        self.docking_client = client(action.DockRobot, "dock_robot")
        self.undocking_client = client(action.UndockRobot, "undock_robot")
        self.following_client = client(action.FollowObject, "follow_object")

    def _create_service_clients(self) -> None:
        entirely, around = srv.ClearEntireCostmap, srv.ClearCostmapAroundPose
        self.change_maps_srv = self.create_client(srv.LoadMap, "map_server/load_map")
        self.clear_costmap_global_srv = self.create_client(
            entirely, "global_costmap/clear_entirely_global_costmap"
        )
        self.clear_costmap_local_srv = self.create_client(
            entirely, "local_costmap/clear_entirely_local_costmap"
        )
        self.clear_costmap_except_region_srv = self.create_client(
            srv.ClearCostmapExceptRegion, "local_costmap/clear_costmap_except_region"
        )
        self.clear_costmap_around_robot_srv = self.create_client(
            srv.ClearCostmapAroundRobot, "local_costmap/clear_costmap_around_robot"
        )
        self.clear_local_costmap_around_pose_srv = self.create_client(
            around, "local_costmap/clear_costmap_around_pose"
        )
        self.clear_global_costmap_around_pose_srv = self.create_client(
            around, "global_costmap/clear_costmap_around_pose"
        )
        self.get_costmap_global_srv = self.create_client(
            srv.GetCostmap, "global_costmap/get_costmap"
        )
        self.get_costmap_local_srv = self.create_client(srv.GetCostmap, "local_costmap/get_costmap")
        self.toggle_collision_monitor_srv = self.create_client(
            srv.Toggle, "collision_monitor/toggle"
        )

    def destroyNode(self) -> None:
        """Destroy the node, as `destroy_node` does."""
        self.destroy_node()

    def _send(self, client: Client, goal: Any, text: str, callback: Any = None) -> Any:
        """Wait for the server, and send a goal. Return its handle if it was accepted."""
        name = client.action_type.__name__
        self.debug(f"Waiting for '{name}' action server")
        while not client.wait_for_server(timeout_sec=_WAIT_S):
            self.info(f"'{name}' action server not available, waiting...")
        self.info(text)
        handle = self._result_of(client.send_goal_async(goal, callback))
        return handle if handle is not None and handle.accepted else None

    def _result_of(self, future: Future[Any]) -> Any:
        """Spin until a future is done, and return its result. A failure is logged."""
        spin_until_future_complete(self, future)
        try:
            return future.result()
        except ZbotError as error:
            self.error(str(error))
            return None

    def _call(self, client: Any, what: str, request: Any) -> Any:
        """Call a service, and return the response, or None if the call failed."""
        while not client.wait_for_service(timeout_sec=_WAIT_S):
            self.info(f"{what} service not available, waiting...")
        response = self._result_of(client.call_async(request))
        if response is None:
            self.error(f"{what} request failed!")
        return response

    def clearPreviousState(self) -> None:
        """Forget the feedback and the error of the last task."""
        self.feedback = None
        self.setTaskError(0, "")

    def setTaskError(self, error_code: int, error_msg: str) -> None:
        """Store the error of a task."""
        self.last_action_error_code, self.last_action_error_msg = error_code, error_msg

    def getTaskError(self) -> tuple[int, str]:
        """Return the error of the last task: a code of its action, and a text."""
        return self.last_action_error_code, self.last_action_error_msg

    def _reason(self, result: Any) -> str:
        code, text = result.error_code, result.error_msg
        return f"status code:{self.status} error code:{code} error msg:{text}"

    def info(self, msg: str) -> None:
        """Log a line of the level INFO."""
        self.get_logger().info(msg)

    def warn(self, msg: str) -> None:
        """Log a line of the level WARN."""
        self.get_logger().warning(msg)

    def error(self, msg: str) -> None:
        """Log a line of the level ERROR."""
        self.get_logger().error(msg)

    def debug(self, msg: str) -> None:
        """Log a line of the level DEBUG."""
        self.get_logger().debug(msg)


def duration(seconds: float) -> Any:
    """Return a time in seconds as a message."""
    return Duration(seconds=seconds).to_msg()
