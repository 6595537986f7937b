"""Save maps in files on request.

Run:        zbot run nav2_map_server map_saver_server, then configure and activate it
Serves:     map_saver/save_map (nav2_msgs/SaveMap)
Parameters: save_map_timeout (2.0 s), free_thresh_default (0.25), occupied_thresh_default (0.65),
            map_subscribe_transient_local (true)
"""

from __future__ import annotations

from typing import Any

import zbot
from zbot.libraries.navigation.map_file import write_map
from zbot.lifecycle import LifecycleNode
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot_nodes.startup.program import run_node

from nav2_msgs.srv import SaveMap
from nav_msgs.msg import OccupancyGrid


class MapSaver(LifecycleNode):
    """Waits for one message of a topic, and writes the map in this message into files.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__("map_saver", **options)
        self.declare_parameter("save_map_timeout", 2.0)
        self.declare_parameter("free_thresh_default", 0.25)
        self.declare_parameter("occupied_thresh_default", 0.65)
        self.declare_parameter("map_subscribe_transient_local", True)
        # `save` waits for a message, so callbacks must be able to run meanwhile.
        self.group = zbot.ReentrantCallbackGroup()
        service = f"{self.get_name()}/save_map"
        self.create_service(SaveMap, service, self.save, callback_group=self.group)

    def setting(self, name: str) -> Any:
        """Return a parameter."""
        return self.get_parameter(name).value

    async def save(self, request: SaveMap.Request, response: SaveMap.Response) -> SaveMap.Response:
        """Write the map of a topic."""
        topic = request.map_topic or "map"
        grid = await self.next_map(topic)
        response.result = False
        if grid is None:
            self.get_logger().error(f"No map came on the topic {topic}")
            return response
        free = request.free_thresh or float(self.setting("free_thresh_default"))
        occupied = request.occupied_thresh or float(self.setting("occupied_thresh_default"))
        try:
            saved = write_map(
                grid,
                request.map_url or "map",
                request.image_format,
                request.map_mode,
                free,
                occupied,
            )
        except zbot.ZbotError as error:
            self.get_logger().error(str(error))
            return response
        self.get_logger().info(f"Map saved in {saved}")
        response.result = True
        return response

    async def next_map(self, topic: str) -> OccupancyGrid | None:
        """Return the next message of a topic, or None if no message comes in time."""
        done: zbot.Future[OccupancyGrid | None] = zbot.Future()

        def finish(grid: OccupancyGrid | None) -> None:
            if not done.done():
                done.set_result(grid)

        kept = self.setting("map_subscribe_transient_local")
        durability = DurabilityPolicy.TRANSIENT_LOCAL if kept else DurabilityPolicy.VOLATILE
        profile = QoSProfile(depth=1, durability=durability)
        subscription = self.create_subscription(
            OccupancyGrid, topic, finish, profile, callback_group=self.group
        )
        timeout_s = float(self.setting("save_map_timeout"))
        real = zbot.Clock(clock_type=zbot.ClockType.STEADY_TIME)
        timer = self.create_timer(
            timeout_s, lambda: finish(None), callback_group=self.group, clock=real
        )
        grid: OccupancyGrid | None = await done
        self.destroy_timer(timer)
        self.destroy_subscription(subscription)
        return grid


def main() -> None:
    """Run until Ctrl-C."""
    run_node(MapSaver)


if __name__ == "__main__":
    main()
