"""Ferry whose departure is a coroutine: it waits for its own ramp without blocking the ramp."""

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.node import Node

from std_srvs.srv import SetBool, Trigger


class Ferry(Node):
    def __init__(self) -> None:
        super().__init__("ferry")
        group = ReentrantCallbackGroup()
        self.is_up = False
        self.trips = 0
        self.create_service(SetBool, "~/ramp", self.move_ramp, callback_group=group)
        self.create_service(Trigger, "~/depart", self.depart, callback_group=group)
        self.ramp = self.create_client(SetBool, "~/ramp", callback_group=group)

    def move_ramp(self, wanted: SetBool.Request, moved: SetBool.Response) -> SetBool.Response:
        moved.success = self.is_up != wanted.data
        self.is_up = wanted.data
        moved.message = f"ramp {'up' if self.is_up else 'down'}"
        self.get_logger().info(moved.message)
        return moved

    async def depart(self, _: Trigger.Request, gone: Trigger.Response) -> Trigger.Response:
        ramp = await self.ramp.call_async(SetBool.Request(data=True))
        self.trips += 1
        gone.success, gone.message = ramp.success, f"trip {self.trips}"
        await self.ramp.call_async(SetBool.Request(data=False))
        return gone


rclpy.init()
try:
    rclpy.spin(Ferry())
except KeyboardInterrupt:
    print("the ferry is moored")
rclpy.try_shutdown()
