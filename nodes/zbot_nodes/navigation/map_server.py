"""Publish a map from a file. The node must be configured and activated.

Run:        zbot run nav2_map_server map_server --ros-args -p yaml_filename:=lab.yaml
            zbot lifecycle set /map_server configure, then activate (or nav2_lifecycle_manager)
Publishes:  map (nav_msgs/OccupancyGrid), kept for late subscribers
Serves:     map_server/map (nav_msgs/GetMap), map_server/load_map (nav2_msgs/LoadMap)
Parameters: yaml_filename (""), topic_name ("map"), frame_id ("map")
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.libraries.navigation.map_file import MapFileError, read_map
from zbot.lifecycle import LifecycleNode, LifecycleState, TransitionCallbackReturn
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot_nodes.startup.program import run_node

from nav2_msgs.srv import LoadMap
from nav_msgs.msg import OccupancyGrid
from nav_msgs.srv import GetMap

if TYPE_CHECKING:
    from zbot.lifecycle import LifecyclePublisher

_KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class MapServer(LifecycleNode):
    """Publishes one map, and returns it to clients.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__("map_server", **options)
        self.map: OccupancyGrid | None = None
        self.publisher: LifecyclePublisher[OccupancyGrid] | None = None
        self.is_active = False
        self.declare_parameter("yaml_filename", "")
        self.declare_parameter("topic_name", "map")
        self.declare_parameter("frame_id", "map")
        prefix = self.get_name()
        self.create_service(GetMap, f"{prefix}/map", self.get_map)
        self.create_service(LoadMap, f"{prefix}/load_map", self.load_map)

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Read the map."""
        self.get_logger().info("Configuring")
        path = str(self.get_parameter("yaml_filename").value)
        if path:
            try:
                self.read(path)
            except MapFileError as error:
                self.get_logger().error(str(error))
                return TransitionCallbackReturn.FAILURE
        else:
            text = "yaml-filename parameter is empty, set map through 'load_map'-service"
            self.get_logger().info(text)
        topic = str(self.get_parameter("topic_name").value)
        self.publisher = self.create_lifecycle_publisher(OccupancyGrid, topic, _KEPT)
        return super().on_configure(state)

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Publish the map."""
        self.get_logger().info("Activating")
        result = super().on_activate(state)
        self.is_active = True
        self.publish()
        return result

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Stop serving the map."""
        self.get_logger().info("Deactivating")
        self.is_active = False
        return super().on_deactivate(state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Forget the map."""
        self.get_logger().info("Cleaning up")
        if self.publisher is not None:
            self.destroy_lifecycle_publisher(self.publisher)
        self.publisher = self.map = None
        return super().on_cleanup(state)

    def read(self, path: str) -> None:
        """Read a map.

        Raises:
            MapFileError: The map cannot be read.
        """
        grid = read_map(path)
        grid.header.frame_id = str(self.get_parameter("frame_id").value)
        grid.header.stamp = grid.info.map_load_time = self.get_clock().now().to_msg()
        self.map = grid
        info = grid.info
        text = f"{info.width} X {info.height} map @ {info.resolution:g} m/cell"
        self.get_logger().info(f"Read map {path}: {text}")

    def publish(self) -> None:
        """Publish the map, if there is one."""
        if self.map is not None and self.publisher is not None:
            self.publisher.publish(self.map)

    def get_map(self, _request: GetMap.Request, response: GetMap.Response) -> GetMap.Response:
        """Answer with the map."""
        if not self.is_active or self.map is None:
            self.get_logger().warn("Received GetMap request but not in ACTIVE state, ignoring!")
            return response
        response.map = self.map
        return response

    def load_map(self, request: LoadMap.Request, response: LoadMap.Response) -> LoadMap.Response:
        """Read another map, and publish it."""
        if not self.is_active:
            self.get_logger().warn("Received LoadMap request but not in ACTIVE state, ignoring!")
            response.result = LoadMap.Response.RESULT_UNDEFINED_FAILURE
            return response
        try:
            self.read(request.map_url)
        except MapFileError as error:
            self.get_logger().error(str(error))
            response.result = _result(error)
            return response
        assert self.map is not None
        response.map, response.result = self.map, LoadMap.Response.RESULT_SUCCESS
        self.publish()
        return response


def _result(error: MapFileError) -> int:
    if error.is_missing:
        return int(LoadMap.Response.RESULT_MAP_DOES_NOT_EXIST)
    if error.is_image:
        return int(LoadMap.Response.RESULT_INVALID_MAP_DATA)
    return int(LoadMap.Response.RESULT_INVALID_MAP_METADATA)


def main() -> None:
    """Run until Ctrl-C."""
    run_node(MapServer)


if __name__ == "__main__":
    main()
