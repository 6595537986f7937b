"""Costmap: a node inside of the planner or the controller that knows what each place costs.

Subscribes: map (nav_msgs/OccupancyGrid) with a static layer; scans with an obstacle layer
Publishes:  costmap (nav_msgs/OccupancyGrid) and costmap_raw (nav2_msgs/Costmap), kept for late
            subscribers; published_footprint (geometry_msgs/PolygonStamped)
Serves:     get_costmap, get_cost_NAME, clear_entirely_NAME, clear_around_NAME and others
"""

from __future__ import annotations

from array import array
from typing import TYPE_CHECKING, Any

import zbot
from zbot.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from zbot_nodes.navigation.costmap_services import CostmapServices
from zbot_nodes.navigation.grids import np
from zbot_nodes.navigation.grids.costs import (
    FREE,
    NO_INFORMATION,
    OBSTACLE,
    Inflation,
    ObstacleLayer,
    to_occupancy,
)
from zbot_nodes.navigation.grids.footprint import footprint_of
from zbot_nodes.navigation.grids.geometry import (
    UNKNOWN,
    GridGeometry,
    cells_of,
    geometry_of,
    grid_message,
    is_whole,
)
from zbot_nodes.navigation.grids.rays import moved, rays_of
from zbot_nodes.navigation.settings import Settings
from zbot_nodes.startup.program import ParameterError

from geometry_msgs.msg import Point32, PolygonStamped
from nav2_msgs.msg import Costmap as CostmapMessage
from nav_msgs.msg import OccupancyGrid
from sensor_msgs.msg import LaserScan

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from zbot_nodes.navigation.robot_frames import RobotFrames
    from zbot_nodes.robot.pose import Pose

_KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
_PATIENCE_S = 0.1  # for the transform of a scan
_SCANS = "LaserScan"
_OCCUPIED = 65


class Costmap(zbot.Node):
    """Costs from the map, and from obstacles that the lidars see.

    Args:
        name: `global_costmap` or `local_costmap`, also the name of its namespace.
        parent: The node whose frames it uses.
        is_rolling: Whether the costmap moves with the robot, if no parameter says it.

    Attributes:
        costs: What each cell costs. None until everything is known.
        geometry: Where the cells are.
    """

    def __init__(self, name: str, parent: Any, *, is_rolling: bool) -> None:
        space = f"{parent.get_namespace().rstrip('/')}/{name}"
        words = ["--ros-args", "-r", f"__node:={name}", "-r", f"__ns:={space}"]
        simulated = parent.get_parameter("use_sim_time")
        given = [simulated] if simulated.value else None
        super().__init__(name, context=parent.context, cli_args=words, parameter_overrides=given)
        self.frames: RobotFrames = parent.frames
        self.settings = Settings(self)
        self.costs: NDArray[np.uint8] | None = None
        self.static: NDArray[np.uint8] | None = None
        self.made: list[Any] = []
        self._read(is_rolling=is_rolling)
        self._open()
        self.settings.name_unused()

    def _read(self, *, is_rolling: bool) -> None:
        """Read the parameters."""
        settings = self.settings
        number, flag = settings.number, settings.flag
        self.is_rolling = flag("rolling_window", default=is_rolling)
        self.frame = settings.text("global_frame", "odom" if is_rolling else "map")
        self.base_frame = settings.text("robot_base_frame", "base_link")
        cell = number("resolution", 0.05)
        size = [round(number(side, 3.0) / cell) for side in ("height", "width")]
        corner = number("origin_x", 0.0), number("origin_y", 0.0)
        self.geometry = GridGeometry(*corner, cell, *size)
        self.obstacles = ObstacleLayer(self.geometry)
        self.tracks_unknown = flag("track_unknown_space", default=False)
        self.period_s = 1 / max(number("update_frequency", 5.0), 0.1)
        self.publish_period_s = 1 / max(number("publish_frequency", 1.0), 0.1)
        try:
            self.footprint = footprint_of(
                settings.text("footprint", "[]"),
                number("robot_radius", 0.1),
                number("footprint_padding", 0.01),
            )
        except ValueError as error:
            raise ParameterError(f"the parameter footprint is not valid: {error}") from error
        self._read_layers()

    def _read_layers(self) -> None:
        default = ["obstacle_layer", "inflation_layer"]
        default = default if self.is_rolling else ["static_layer", *default]
        names = self.settings.texts("plugins", default)
        kinds = {name: self._kind(name) for name in names}
        self.inflation = Inflation(self.footprint.inscribed_m, 0.0)
        for name, kind in kinds.items():
            if kind == "static":
                self._static(name)
            elif kind in {"obstacle", "voxel"}:
                self._sources(name)
            elif kind == "inflation":
                self.inflation = Inflation(
                    self.footprint.inscribed_m,
                    self.settings.number(f"{name}.inflation_radius", 0.55),
                    self.settings.number(f"{name}.cost_scaling_factor", 3.0),
                )

    def _kind(self, layer: str) -> str:
        """Return the kind of a layer: its class without `nav2_costmap_2d::` and `Layer`."""
        default = f"nav2_costmap_2d::{layer.title().replace('_', '')}"
        kind = self.settings.text(f"{layer}.plugin", default)
        self.settings.flag(f"{layer}.enabled", default=True)
        return kind.replace("/", "::").rpartition("::")[2].removesuffix("Layer").lower()

    def _static(self, layer: str) -> None:
        self.settings.flag(f"{layer}.map_subscribe_transient_local", default=True)
        topic = self.settings.text(f"{layer}.map_topic", "") or "/map"
        topic = topic if topic.startswith("/") else f"{self._outside()}/{topic}"
        if topic == "/map":
            topic = f"{self._outside()}/map"
        self.made.append(self.create_subscription(OccupancyGrid, topic, self.take_map, _KEPT))

    def _outside(self) -> str:
        """Return the namespace around that of the costmap, in which the robot's topics are."""
        return self.get_namespace().rpartition("/")[0]

    def _sources(self, layer: str) -> None:
        settings = self.settings
        for source in settings.texts(f"{layer}.observation_sources", ["scan"]):
            name = f"{layer}.{source}"
            if settings.text(f"{name}.data_type", _SCANS) != _SCANS:
                self.get_logger().warning(f"{name} is left out: only {_SCANS} is supported")
                continue
            topic = settings.text(f"{name}.topic", source)
            topic = topic if topic.startswith("/") else f"{self._outside()}/{topic}"
            mark_m = settings.first((f"{name}.obstacle_max_range", f"{name}.obstacle_range"), 2.5)
            clear_m = settings.first((f"{name}.raytrace_max_range", f"{name}.raytrace_range"), 3.0)
            for flag in ("marking", "clearing"):
                settings.flag(f"{name}.{flag}", default=True)

            def take(scan: Any, mark_m: float = mark_m, clear_m: float = clear_m) -> None:
                self.take_scan(scan, mark_m, clear_m)

            self.made.append(
                self.create_subscription(LaserScan, topic, take, qos_profile_sensor_data)
            )

    def _open(self) -> None:
        self.publisher = self.create_publisher(OccupancyGrid, "costmap", _KEPT)
        self.raw_publisher = self.create_publisher(CostmapMessage, "costmap_raw", _KEPT)
        self.outline_publisher = self.create_publisher(PolygonStamped, "published_footprint", 10)
        self.services_made = CostmapServices(self)
        self.create_timer(self.period_s, self.update)
        self.create_timer(self.publish_period_s, self.publish)

    # -- what is seen --------------------------------------------------------------------------

    def take_map(self, message: OccupancyGrid) -> None:
        """Use a map from now on."""
        if not is_whole(message):
            self.get_logger().error("The map does not have as many cells as it says")
            return
        cells = cells_of(message)
        static = np.where(cells >= _OCCUPIED, OBSTACLE, FREE).astype(np.uint8)
        if self.tracks_unknown:
            static[cells == UNKNOWN] = NO_INFORMATION
        self.static = static
        geometry = geometry_of(message.info)
        if geometry != self.geometry and not self.is_rolling:
            self.geometry = geometry
            self.obstacles = ObstacleLayer(geometry)
        self.update()

    def take_scan(self, scan: LaserScan, mark_m: float, clear_m: float) -> None:
        """Add what a lidar sees."""
        stamp = scan.header.stamp
        lidar = self.frames.rigid(self.frame, scan.header.frame_id, stamp, wait_s=_PATIENCE_S)
        if lidar is None:
            return
        if self.is_rolling:
            self.obstacles.move_to(lidar.translation[0], lidar.translation[1])
        self.obstacles.add(rays_of(scan, lidar), mark_m=mark_m, clear_m=clear_m)

    def robot_pose(self) -> Pose | None:
        """Return the pose of the robot in the frame of the costmap."""
        return self.frames.pose(self.frame, self.base_frame)

    def update(self) -> None:
        """Compute the costs anew."""
        if not self.is_rolling and self.static is None:
            return
        occupied = self.obstacles.cells
        if not self.is_rolling and self.static is not None:
            occupied = occupied | (self.static == OBSTACLE)
        costs = self.inflation.costs(occupied, self.geometry.resolution)
        if not self.is_rolling and self.static is not None:
            costs[(self.static == NO_INFORMATION) & (costs == FREE)] = NO_INFORMATION
        self.geometry, self.costs = self.obstacles.geometry, costs

    # -- what is published ---------------------------------------------------------------------

    def publish(self) -> None:
        """Publish the costs and the outline of the robot, if somebody listens."""
        if self.costs is None:
            return
        stamp = self.get_clock().now().to_msg()
        if self.publisher.get_subscription_count():
            percent = to_occupancy(self.costs)
            self.publisher.publish(grid_message(percent, self.geometry, self.frame, stamp))
        if self.raw_publisher.get_subscription_count():
            self.raw_publisher.publish(self.message())
        if self.outline_publisher.get_subscription_count():
            self._publish_outline(stamp)

    def _publish_outline(self, stamp: Any) -> None:
        pose = self.robot_pose()
        if pose is None:
            return
        message = PolygonStamped()
        message.header.frame_id, message.header.stamp = self.frame, stamp
        corners = moved(self.footprint.corners, pose).tolist()
        message.polygon.points = [Point32(x=x, y=y) for x, y in corners]
        self.outline_publisher.publish(message)

    def message(self) -> Any:
        """Return the costs as nav2_msgs/Costmap."""
        message = CostmapMessage()
        stamp = self.get_clock().now().to_msg()
        message.header.frame_id, message.header.stamp = self.frame, stamp
        data, geometry = message.metadata, self.geometry
        data.update_time, data.layer, data.resolution = stamp, "master", geometry.resolution
        data.size_y, data.size_x = geometry.shape
        data.origin.position.x, data.origin.position.y = geometry.x, geometry.y
        if self.costs is not None:
            message.data = array("B", self.costs.tobytes())
        return message
