"""Add two integers for every client.

Run:    zbot run add_two_ints_server
Serves: add_two_ints (example_interfaces/srv/AddTwoInts)
Ask it: zbot service call /add_two_ints example_interfaces/srv/AddTwoInts "{a: 5, b: 3}"
"""

import zbot

from example_interfaces.srv import AddTwoInts


class ServiceNode(zbot.Node):
    """Answers each request with the sum of its two numbers."""

    def __init__(self) -> None:
        super().__init__("service_node")
        self.srv = self.create_service(AddTwoInts, "add_two_ints", self.add_two_ints_callback)

    def add_two_ints_callback(
        self, request: AddTwoInts.Request, response: AddTwoInts.Response
    ) -> AddTwoInts.Response:
        """Answer one request."""
        response.sum = request.a + request.b
        self.get_logger().info(f"{request.a} + {request.b} = {response.sum}")
        return response


def main() -> None:
    """Run until Ctrl-C."""
    with zbot.init():
        zbot.spin(ServiceNode())


if __name__ == "__main__":
    main()
