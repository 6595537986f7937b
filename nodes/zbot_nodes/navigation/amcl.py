"""Find out where a robot is in a map, with a particle filter.

Run:        zbot run nav2_amcl amcl, then configure and activate it (or nav2_lifecycle_manager)
Subscribes: map (nav_msgs/OccupancyGrid), scan (sensor_msgs/LaserScan), /tf from odom to the robot,
            initialpose (geometry_msgs/PoseWithCovarianceStamped)
Publishes:  amcl_pose (geometry_msgs/PoseWithCovarianceStamped), kept for late subscribers;
            particle_cloud (nav2_msgs/ParticleCloud); /tf from map to odom
Serves:     reinitialize_global_localization, request_nomotion_update (std_srvs/Empty),
            set_initial_pose (nav2_msgs/SetInitialPose)
"""

from __future__ import annotations

import math
from typing import Any

from zbot.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from zbot.tf2 import TransformBroadcaster
from zbot.time import Duration
from zbot_nodes.navigation.grids import np
from zbot_nodes.navigation.grids.geometry import cells_of, geometry_of, is_whole
from zbot_nodes.navigation.grids.particle_filter import LikelihoodField, MotionNoise, ParticleFilter
from zbot_nodes.navigation.grids.rays import rays_of
from zbot_nodes.navigation.managed_server import ManagedServer
from zbot_nodes.navigation.robot_frames import transform_message
from zbot_nodes.robot.pose import Pose, to_quaternion
from zbot_nodes.startup.program import run_node

from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped
from nav2_msgs.msg import Particle, ParticleCloud
from nav2_msgs.srv import SetInitialPose
from nav_msgs.msg import OccupancyGrid
from sensor_msgs.msg import LaserScan
from std_srvs.srv import Empty

_KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
_PATIENCE_S = 0.3  # for the transform of a scan
_OCCUPIED = 65
_START_VARIANCES = (0.25, 0.25, 0.068)
_TF_PERIOD_S, _MOST_AHEAD_S = 0.1, 0.2
_SHOWN = 500  # particles in one message


class Amcl(ManagedServer):
    """Keeps many guesses of the robot's pose, and weighs them by each scan.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__("amcl", **options)
        self.filter = ParticleFilter()
        self.field: LikelihoodField | None = None
        self.free: Any = None
        self.last_odom: Pose | None = None
        self.map_to_odom: Pose | None = None
        self.start: PoseWithCovarianceStamped | None = None
        self.is_searching = False  #: whether there are guesses
        self.updates, self.must_update = 0, False

    def configure(self) -> None:
        """Read the parameters."""
        settings = self.settings
        number, text, flag = settings.number, settings.text, settings.flag
        self.map_frame = text("global_frame_id", "map")
        self.odom_frame = text("odom_frame_id", "odom")
        self.base_frame = text("base_frame_id", "base_footprint")
        self.rays = int(number("max_beams", 60))
        self.farthest_m = number("laser_max_range", 100.0)
        self.least, self.most = (
            int(number("min_particles", 500)),
            int(number("max_particles", 2000)),
        )
        self.error, self.z = number("pf_err", 0.05), number("pf_z", 0.99)
        self.least_way_m, self.least_turn = (
            number("update_min_d", 0.25),
            number("update_min_a", 0.2),
        )
        self.resample_interval = max(1, int(number("resample_interval", 1)))
        # Others see a new transform only when its time has come, so it is not far ahead.
        self.tf_ahead_s = min(number("transform_tolerance", 1.0), _MOST_AHEAD_S)
        self.has_tf = flag("tf_broadcast", default=True)
        self.keeps_first_map = flag("first_map_only", default=False)
        self.field_options = {
            "sigma_m": number("sigma_hit", 0.2),
            "farthest_m": number("laser_likelihood_max_dist", 2.0),
            "share": number("z_hit", 0.5) / (number("z_hit", 0.5) + number("z_rand", 0.5)),
        }
        kind = text("robot_model_type", "nav2_amcl::DifferentialMotionModel")
        self.noise = MotionNoise(
            turn_by_turn=number("alpha1", 0.2),
            turn_by_way=number("alpha2", 0.2),
            way_by_way=number("alpha3", 0.2),
            way_by_turn=number("alpha4", 0.2),
            strafe_by_way=number("alpha5", 0.2),
            is_omnidirectional="omni" in kind.lower(),
        )
        start = Pose(*(number(f"initial_pose.{axis}", 0.0) for axis in ("x", "y", "yaw")))
        if flag("set_initial_pose", default=False):
            self.start = self.pose_message(start, np.diag(_START_VARIANCES))
        self.open_topics(text("scan_topic", "scan"), text("map_topic", "map"))

    def open_topics(self, scan: str, map_topic: str) -> None:
        """Create the topics and services."""
        self.broadcaster = TransformBroadcaster(self)
        self.poses = self.create_publisher(PoseWithCovarianceStamped, "amcl_pose", _KEPT)
        self.clouds = self.create_publisher(
            ParticleCloud, "particle_cloud", qos_profile_sensor_data
        )
        self.inputs: list[Any] = [
            self.create_subscription(OccupancyGrid, map_topic, self.take_map, _KEPT),
            self.create_subscription(LaserScan, scan, self.take, qos_profile_sensor_data),
            self.create_subscription(PoseWithCovarianceStamped, "initialpose", self.begin, 10),
        ]
        self.services_made = [
            self.create_service(Empty, "reinitialize_global_localization", self.spread),
            self.create_service(Empty, "request_nomotion_update", self.update_now),
            self.create_service(SetInitialPose, "set_initial_pose", self.set_start),
        ]
        self.timer = self.create_timer(_TF_PERIOD_S, self.publish_transform)

    def clean_up(self) -> None:
        """Destroy the topics and services."""
        for entity in self.inputs:
            self.destroy_subscription(entity)
        for service in self.services_made:
            self.destroy_service(service)
        self.destroy_publisher(self.poses)
        self.destroy_publisher(self.clouds)
        self.destroy_timer(self.timer)
        self.field = self.map_to_odom = self.last_odom = None
        self.is_searching = False

    # -- the start -----------------------------------------------------------------------------

    def take_map(self, message: OccupancyGrid) -> None:
        """Use a map from now on."""
        if not is_whole(message):
            self.get_logger().error("The map does not have as many cells as it says")
            return
        if self.field is not None and self.keeps_first_map:
            return
        cells, geometry = cells_of(message), geometry_of(message.info)
        self.field = LikelihoodField(cells >= _OCCUPIED, geometry, **self.field_options)
        self.free = geometry.centres(*np.nonzero(cells == 0))
        height, width = cells.shape
        self.get_logger().info(f"Received a {width} X {height} map")
        if self.start is not None and not self.is_searching:
            self.begin(self.start)

    def begin(self, message: PoseWithCovarianceStamped) -> None:
        """Begin to search around a pose."""
        self.start = message
        if self.field is None:
            self.get_logger().info("Waiting for a map")
            return
        pose = self.frames.moved(_stamped(message), self.map_frame)
        if pose is None:
            return
        axes = np.array([0, 1, 5])
        covariance = np.array(message.pose.covariance).reshape(6, 6)[np.ix_(axes, axes)]
        if not np.any(covariance):
            covariance = np.diag(_START_VARIANCES)
        self.get_logger().info(f"Setting pose: {pose.x:.3f} {pose.y:.3f} {pose.yaw:.3f}")
        self.filter.spread_around(pose, covariance, self.most)
        self.begin_again(pose)

    def begin_again(self, pose: Pose) -> None:
        """Use new guesses. The next scan weighs them, even if the robot does not move."""
        self.last_odom, self.updates, self.is_searching = None, 0, True
        self.poses.publish(self.pose_message(pose, self.filter.estimate().covariance))

    def set_start(self, request: Any, response: Any) -> Any:
        """Begin to search around the pose of a request."""
        self.begin(request.pose)
        return response

    def spread(self, _request: Any, response: Any) -> Any:
        """Begin to search in the whole map."""
        if self.free is not None and len(self.free):
            self.get_logger().info("Initializing with uniform distribution")
            self.filter.spread_over(self.free, self.most)
            self.begin_again(self.filter.estimate().pose)
        return response

    def update_now(self, _request: Any, response: Any) -> Any:
        """Use the next scan, even if the robot does not move."""
        self.must_update = True
        return response

    # -- each scan -----------------------------------------------------------------------------

    def take(self, scan: LaserScan) -> None:
        """Move and weigh the guesses, if the robot has moved enough."""
        if not self.is_active or self.field is None or not self.is_searching:
            return
        stamp = scan.header.stamp
        odom = self.frames.pose(self.odom_frame, self.base_frame, stamp, wait_s=_PATIENCE_S)
        lidar = self.frames.rigid(self.base_frame, scan.header.frame_id)
        if odom is None or lidar is None:
            return
        motion = None if self.last_odom is None else self.last_odom.inverse() @ odom
        if motion is not None:
            is_far = math.hypot(motion.x, motion.y) >= self.least_way_m
            if not (is_far or abs(motion.yaw) >= self.least_turn or self.must_update):
                return
            self.filter.move(motion, self.noise)
        self.last_odom, self.must_update = odom, False
        rays = rays_of(scan, lidar).up_to(self.farthest_m)
        hits = rays.hits[:: max(1, len(rays.hits) // self.rays)]
        self.filter.weigh(self.field, hits)
        estimate = self.filter.estimate()
        self.updates += 1
        if self.updates % self.resample_interval == 0:
            self.filter.resample(self.least, self.most, error=self.error, z=self.z)
        self.map_to_odom = estimate.pose @ odom.inverse()
        self.publish(estimate.pose, estimate.covariance, stamp)

    def publish(self, pose: Pose, covariance: Any, stamp: Any) -> None:
        """Publish the pose and the guesses."""
        message = self.pose_message(pose, covariance)
        message.header.stamp = stamp
        self.poses.publish(message)
        if self.clouds.get_subscription_count():
            self.clouds.publish(self.cloud(message.header))

    def cloud(self, header: Any) -> Any:
        """Return some of the guesses as a message."""
        cloud = ParticleCloud(header=header)
        step = max(1, len(self.filter.poses) // _SHOWN)
        chosen = zip(self.filter.poses[::step].tolist(), self.filter.weights[::step], strict=True)
        for (x, y, yaw), weight in chosen:
            particle = Particle(weight=float(weight))
            particle.pose.position.x, particle.pose.position.y = x, y
            particle.pose.orientation = to_quaternion(yaw)
            cloud.particles.append(particle)
        return cloud

    def pose_message(self, pose: Pose, covariance: Any) -> Any:
        """Return a pose with its covariance as a message."""
        message = PoseWithCovarianceStamped()
        message.header.frame_id, message.header.stamp = self.map_frame, self.stamp()
        place = message.pose.pose.position
        place.x, place.y = pose.x, pose.y
        message.pose.pose.orientation = to_quaternion(pose.yaw)
        full = np.zeros((6, 6))
        axes = np.array([0, 1, 5])
        full[np.ix_(axes, axes)] = covariance
        message.pose.covariance = full.ravel()
        return message

    def publish_transform(self) -> None:
        """Publish where the odometry began in the map."""
        if not (self.is_active and self.has_tf) or self.map_to_odom is None:
            return
        # The transform is also valid a little later, so that others need not wait for the next.
        stamp = (self.get_clock().now() + Duration(seconds=self.tf_ahead_s)).to_msg()
        self.broadcaster.sendTransform(
            transform_message(self.map_frame, self.odom_frame, self.map_to_odom, stamp)
        )


def _stamped(message: PoseWithCovarianceStamped) -> Any:
    """Return a pose without its covariance."""
    return PoseStamped(header=message.header, pose=message.pose.pose)


def main() -> None:
    """Run until Ctrl-C."""
    run_node(Amcl)


if __name__ == "__main__":
    main()
