"""Timer callback that calls a service and waits for the response, in a node with one thread.

The service is the node's own: while the timer callback waits, the thread runs the service callback.
"""

import zbot

from example_interfaces.srv import AddTwoInts


class Calculator(zbot.Node):
    def __init__(self) -> None:
        super().__init__("calculator")
        self.sum = 1
        self.create_service(AddTwoInts, "add_two_ints", self.add)
        self.adder = self.create_client(AddTwoInts, "add_two_ints")
        self.create_timer(0.5, self.double)

    def add(
        self, request: AddTwoInts.Request, response: AddTwoInts.Response
    ) -> AddTwoInts.Response:
        response.sum = request.a + request.b
        return response

    def double(self) -> None:
        answer = self.adder.call(AddTwoInts.Request(a=self.sum, b=self.sum))
        self.get_logger().info(f"{self.sum} + {self.sum} = {answer.sum}")
        self.sum = answer.sum if answer.sum < 1_000_000 else 1


if __name__ == "__main__":
    with zbot.init():
        zbot.spin(Calculator())
