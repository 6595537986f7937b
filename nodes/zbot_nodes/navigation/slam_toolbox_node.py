"""Make a map of what a lidar sees, and say where the robot is in it.

Run:        zbot run slam_toolbox async_slam_toolbox_node
            (it configures and activates itself, unless another program does)
Subscribes: scan (sensor_msgs/LaserScan), /tf from odom to the robot
Publishes:  map (nav_msgs/OccupancyGrid), kept for late subscribers; pose; /tf from map to odom
Serves:     slam_toolbox/save_map (slam_toolbox/SaveMap), dynamic_map (nav_msgs/GetMap),
            slam_toolbox/pause_new_measurements (slam_toolbox/Pause), reset (slam_toolbox/Reset)
Parameters: resolution (0.05 m), map_update_interval (5.0 s), minimum_travel_distance (0.1 m) ...
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from slam_toolbox.srv import Pause, Reset, SaveMap

import zbot
from zbot.libraries.navigation.map_file import MapFileError, write_map
from zbot.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from zbot.tf2 import TransformBroadcaster
from zbot.time import Duration
from zbot_nodes.navigation.grids.geometry import grid_message
from zbot_nodes.navigation.grids.occupancy_map import OccupancyMap
from zbot_nodes.navigation.grids.rays import rays_of
from zbot_nodes.navigation.grids.scan_matcher import ScanMatcher
from zbot_nodes.navigation.managed_server import ManagedServer
from zbot_nodes.navigation.robot_frames import transform_message
from zbot_nodes.robot.pose import Pose, to_quaternion
from zbot_nodes.startup.program import run_node

from geometry_msgs.msg import PoseWithCovarianceStamped
from lifecycle_msgs.msg import Transition
from nav_msgs.msg import OccupancyGrid
from nav_msgs.srv import GetMap
from sensor_msgs.msg import LaserScan

if TYPE_CHECKING:
    from zbot.lifecycle import TransitionCallbackReturn
    from zbot_nodes.navigation.grids.rays import Rays

_KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
_PATIENCE_S = 0.3  # for the transform of a scan
_ALONE_S = 3.0  # after this time, a node that nobody configures starts itself
_WORST_MATCH_M = 0.15  # a match with a larger error does not count


class Mapper(ManagedServer):
    """Matches each scan with the map so far, and then adds it.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__("slam_toolbox", **options)
        self.map = OccupancyMap(0.05)
        self.map_to_odom = Pose()
        self.last_odom: Pose | None = None
        self.is_paused = self.is_changed = self.is_started_alone = False
        self.create_service(SaveMap, "slam_toolbox/save_map", self.save)
        self.create_service(GetMap, "slam_toolbox/dynamic_map", self.get_map)
        self.create_service(Pause, "slam_toolbox/pause_new_measurements", self.pause)
        self.create_service(Reset, "slam_toolbox/reset", self.reset)
        real = zbot.Clock(clock_type=zbot.ClockType.STEADY_TIME)
        self.alone = self.create_timer(_ALONE_S, self.start_alone, clock=real)

    def start_alone(self) -> None:
        """Configure and activate the node, if no other program does."""
        if self.count_clients(f"{self.get_name()}/change_state"):
            return  # a lifecycle manager will do it
        self.destroy_timer(self.alone)
        if self._state_machine.current_state[1] == "unconfigured":
            self.trigger_configure()
            self.trigger_activate()
            self.is_started_alone = True

    def _zbot_change_state(self, wanted: str | int) -> TransitionCallbackReturn:
        # A lifecycle manager may come late, because many programs start together. It may start the
        # node again. Otherwise it would give up all of its nodes.
        if self.is_started_alone and wanted == Transition.TRANSITION_CONFIGURE:
            self.is_started_alone = False
            self.trigger_deactivate()
            self.trigger_cleanup()
        return super()._zbot_change_state(wanted)

    def configure(self) -> None:
        """Read the parameters."""
        settings = self.settings
        self.map = OccupancyMap(settings.number("resolution", 0.05))
        self.last_odom, self.map_to_odom = None, Pose()
        self.map_frame = settings.text("map_frame", "map")
        self.odom_frame = settings.text("odom_frame", "odom")
        self.base_frame = settings.text("base_frame", "base_footprint")
        self.scan_topic = settings.text("scan_topic", "scan")
        self.map_name = settings.text("map_name", "map")
        self.farthest_m = settings.number("max_laser_range", 20.0)
        self.least_way_m = min(settings.number("minimum_travel_distance", 0.1), 0.2)
        self.least_turn = min(settings.number("minimum_travel_heading", 0.1), 0.2)
        self.map_period_s = settings.number("map_update_interval", 5.0)
        self.is_matching = settings.flag("use_scan_matching", default=True)
        self.tf_period_s = settings.number("transform_publish_period", 0.05)
        self.tf_ahead_s = settings.number("transform_timeout", 0.2)
        mode = settings.text("mode", "mapping")
        if mode != "mapping":
            self.get_logger().warning(
                f"the mode '{mode}' is left out: a new map begins where the robot is; "
                "`zbot launch nav2_bringup localization_launch.py map:=MAP.yaml` localizes in a "
                "saved map"
            )

    def activate(self) -> None:
        """Listen to the lidar."""
        self.publisher = self.create_publisher(OccupancyGrid, self.map_name, _KEPT)
        self.poses = self.create_publisher(PoseWithCovarianceStamped, "pose", 10)
        self.broadcaster = TransformBroadcaster(self)
        self.scans = self.create_subscription(
            LaserScan, self.scan_topic, self.take, qos_profile_sensor_data
        )
        self.timers_made = [self.create_timer(self.map_period_s, self.publish)]
        if self.tf_period_s > 0:
            self.timers_made.append(self.create_timer(self.tf_period_s, self.publish_transform))

    def deactivate(self) -> None:
        """Stop listening. The map stays."""
        self.destroy_subscription(self.scans)
        for timer in self.timers_made:
            self.destroy_timer(timer)
        self.destroy_publisher(self.publisher)
        self.destroy_publisher(self.poses)

    def take(self, scan: LaserScan) -> None:
        """Match and add a scan, if the robot has moved since the last one."""
        stamp, frame = scan.header.stamp, scan.header.frame_id
        odom = self.frames.pose(self.odom_frame, self.base_frame, stamp, wait_s=_PATIENCE_S)
        lidar = self.frames.rigid(self.base_frame, frame) if odom is not None else None
        if odom is None or lidar is None or self.is_paused or not self.has_moved(odom):
            return
        is_first, self.last_odom = self.last_odom is None, odom
        rays = rays_of(scan, lidar).up_to(self.farthest_m)
        pose = self.map_to_odom @ odom
        if self.is_matching and not is_first:
            pose = self.matched(rays, pose)
        self.map_to_odom = pose @ odom.inverse()
        self.map.add(rays.seen_from(pose))
        self.is_changed = True
        self.publish_pose(pose, stamp)
        if is_first:
            self.publish()

    def has_moved(self, odom: Pose) -> bool:
        """Return whether the robot is far enough from the place of the last scan."""
        if self.last_odom is None:
            return True
        way = self.last_odom.inverse() @ odom
        return math.hypot(way.x, way.y) >= self.least_way_m or abs(way.yaw) >= self.least_turn

    def matched(self, rays: Rays, guess: Pose) -> Pose:
        """Return the pose at which a scan fits to the map, or the guess if it fits nowhere."""
        found = ScanMatcher(self.map.occupied, self.map.geometry).match(rays.hits, guess)
        if found.error_m > _WORST_MATCH_M:
            self.get_logger().warning(
                f"a scan does not fit to the map (mean error {found.error_m:.2f} m): the "
                "odometry is used",
                throttle_duration_sec=5.0,
            )
            return guess
        return found.pose

    def message(self) -> Any:
        """Return the map as a message."""
        return grid_message(self.map.cells(), self.map.geometry, self.map_frame, self.stamp())

    def publish(self) -> None:
        """Publish the map, if it has changed."""
        if self.is_changed:
            self.is_changed = False
            self.publisher.publish(self.message())

    def publish_pose(self, pose: Pose, stamp: Any) -> None:
        """Publish where the robot is."""
        message = PoseWithCovarianceStamped()
        message.header.frame_id, message.header.stamp = self.map_frame, stamp
        message.pose.pose.position.x, message.pose.pose.position.y = pose.x, pose.y
        message.pose.pose.orientation = to_quaternion(pose.yaw)
        self.poses.publish(message)

    def publish_transform(self) -> None:
        """Publish where the odometry began in the map."""
        if self.last_odom is None:
            return
        # The transform is also valid a little later, so that others need not wait for the next.
        stamp = (self.get_clock().now() + Duration(seconds=self.tf_ahead_s)).to_msg()
        self.broadcaster.sendTransform(
            transform_message(self.map_frame, self.odom_frame, self.map_to_odom, stamp)
        )

    def save(self, request: SaveMap.Request, response: SaveMap.Response) -> SaveMap.Response:
        """Write the map into two files."""
        response.result = SaveMap.Response.RESULT_NO_MAP_RECEIEVD
        if self.last_odom is None:
            return response
        try:
            saved = write_map(self.message(), request.name.data or "map", "", "", 0.0, 0.0)
        except MapFileError as error:
            self.get_logger().error(str(error))
            response.result = SaveMap.Response.RESULT_UNDEFINED_FAILURE
            return response
        self.get_logger().info(f"Map saved in {saved}")
        response.result = SaveMap.Response.RESULT_SUCCESS
        return response

    def get_map(self, _request: GetMap.Request, response: GetMap.Response) -> GetMap.Response:
        """Answer with the map."""
        response.map = self.message()
        return response

    def pause(self, _request: Pause.Request, response: Pause.Response) -> Pause.Response:
        """Pause, or go on."""
        self.is_paused = not self.is_paused
        response.status = True
        return response

    def reset(self, request: Reset.Request, response: Reset.Response) -> Reset.Response:
        """Begin a new map."""
        self.map = OccupancyMap(self.map.geometry.resolution)
        self.last_odom, self.map_to_odom = None, Pose()
        self.is_paused = request.pause_new_measurements
        response.result = Reset.Response.RESULT_SUCCESS
        return response


def main() -> None:
    """Run until Ctrl-C."""
    run_node(Mapper)


if __name__ == "__main__":
    main()
