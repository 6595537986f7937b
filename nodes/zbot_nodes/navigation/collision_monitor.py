"""Stop or slow a robot down that is too close to an obstacle, whatever it is commanded.

Run:        zbot run nav2_collision_monitor collision_monitor, then configure and activate it
Subscribes: cmd_vel_smoothed (geometry_msgs/Twist, or TwistStamped with enable_stamped_cmd_vel),
            and the scans of its parameters
Publishes:  cmd_vel (of the same type), collision_monitor_state (nav2_msgs/CollisionMonitorState)
Serves:     collision_monitor/toggle (nav2_msgs/Toggle)
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from zbot.qos import qos_profile_sensor_data
from zbot_nodes.navigation.grids import np
from zbot_nodes.navigation.grids.rays import rays_of
from zbot_nodes.navigation.guarded_area import GuardedArea
from zbot_nodes.navigation.managed_server import ManagedServer
from zbot_nodes.navigation.velocity_publisher import VelocityPublisher, velocity_subscription
from zbot_nodes.startup.program import run_node

from nav2_msgs.msg import CollisionMonitorState
from nav2_msgs.srv import Toggle
from sensor_msgs.msg import LaserScan

if TYPE_CHECKING:
    from numpy.typing import NDArray

_NO_POINTS = np.zeros((0, 2))


class CollisionMonitor(ManagedServer):
    """Passes on commands, and makes them slower if an area around the robot is not free.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__("collision_monitor", **options)
        self.seen: dict[str, tuple[float, NDArray[np.float64]]] = {}
        self.is_on = True
        self.last_state = (CollisionMonitorState.DO_NOTHING, "")

    def configure(self) -> None:
        """Create the areas and the topics."""
        settings = self.settings
        self.base_frame = settings.text("base_frame_id", "base_footprint")
        self.timeout_s = settings.number("source_timeout", 2.0)
        names = settings.texts("polygons", [])
        areas = [GuardedArea.of(settings, name) for name in names]
        self.areas = [area for area in areas if area is not None]
        for name, area in zip(names, areas, strict=True):
            if area is None:
                self.get_logger().warning(f"{name} is left out: it has neither points nor radius")
        self.scans = [
            scan
            for name in settings.texts("observation_sources", [])
            if (scan := self.source(name))
        ]
        self.velocities = VelocityPublisher(self, settings.text("cmd_vel_out_topic", "cmd_vel"))
        topic = settings.text("cmd_vel_in_topic", "cmd_vel_smoothed")
        self.commands = velocity_subscription(self, topic, self.take)
        self.states = self.create_publisher(
            CollisionMonitorState, settings.text("state_topic", "collision_monitor_state"), 10
        )
        self.service = self.create_service(Toggle, f"{self.get_name()}/toggle", self.toggle)

    def source(self, name: str) -> Any:
        """Return the subscription of a source of points, or None if it is not supported."""
        kind = self.settings.text(f"{name}.type", "scan")
        topic = self.settings.text(f"{name}.topic", "scan")
        if kind != "scan" or not self.settings.flag(f"{name}.enabled", default=True):
            self.get_logger().warning(f"{name} is left out: only sources of the type scan are read")
            return None

        def take(scan: Any) -> None:
            lidar = self.frames.rigid(self.base_frame, scan.header.frame_id)
            if lidar is not None:
                self.seen[name] = self.seconds(), rays_of(scan, lidar).hits

        return self.create_subscription(LaserScan, topic, take, qos_profile_sensor_data)

    def clean_up(self) -> None:
        """Destroy the topics."""
        self.velocities.close()
        for entity in (*self.scans, self.commands):
            self.destroy_subscription(entity)
        self.destroy_publisher(self.states)
        self.destroy_service(self.service)

    def toggle(self, request: Any, response: Any) -> Any:
        """Switch the areas on or off."""
        self.is_on, response.success = request.enable, True
        return response

    def points(self) -> NDArray[np.float64]:
        """Return the points that were seen lately, in the frame of the robot."""
        now_s = self.seconds()
        recent = [
            points
            for came_s, points in self.seen.values()
            if not self.timeout_s or now_s - came_s <= self.timeout_s
        ]
        return np.vstack(recent) if recent else _NO_POINTS

    def take(self, twist: Any) -> None:
        """Pass on a command, as fast as the areas allow."""
        if not self.is_active:
            return
        command = (twist.linear.x, twist.linear.y, twist.angular.z)
        share, state = 1.0, (CollisionMonitorState.DO_NOTHING, "")
        points = self.points() if self.is_on and any(command) else _NO_POINTS
        for area in self.areas if len(points) else ():
            allowed = area.allowed_share(command, points)
            if allowed < share:
                share, state = allowed, (area.state, area.name)
        if state != self.last_state:
            self.last_state = state
            self.states.publish(CollisionMonitorState(action_type=state[0], polygon_name=state[1]))
        forward, left, turn = (value * share for value in command)
        if all(map(math.isfinite, (forward, left, turn))):
            self.velocities.publish(forward, turn, left)


def main() -> None:
    """Run until Ctrl-C."""
    run_node(CollisionMonitor)


if __name__ == "__main__":
    main()
