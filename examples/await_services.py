"""Callbacks that wait with `await`: one thread runs two services, and neither blocks the other."""

import zbot

from std_srvs.srv import Trigger


class Kitchen(zbot.Node):
    def __init__(self) -> None:
        super().__init__("kitchen")
        group = zbot.ReentrantCallbackGroup()
        self.create_service(Trigger, "boil", self.boil, callback_group=group)
        self.create_service(Trigger, "breakfast", self.breakfast, callback_group=group)
        self.boiler = self.create_client(Trigger, "boil", callback_group=group)
        self.guest = self.create_client(Trigger, "breakfast", callback_group=group)
        self.create_timer(1.0, self.ask, callback_group=group)

    def boil(self, _: Trigger.Request, response: Trigger.Response) -> Trigger.Response:
        response.success, response.message = True, "hot water"
        return response

    async def breakfast(self, _: Trigger.Request, response: Trigger.Response) -> Trigger.Response:
        water = await self.boiler.call_async(Trigger.Request())
        response.success, response.message = True, f"tea of {water.message}"
        return response

    async def ask(self) -> None:
        meal = await self.guest.call_async(Trigger.Request())
        self.get_logger().info(f"here is your {meal.message}")


if __name__ == "__main__":
    with zbot.init():
        zbot.spin(Kitchen())
