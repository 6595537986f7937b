"""Server of a service: it answers each request with a response."""

import zbot

from example_interfaces.srv import AddTwoInts


class Server(zbot.Node):
    def __init__(self) -> None:
        super().__init__("server")
        self.create_service(AddTwoInts, "add_two_ints", self.add)
        self.get_logger().info("the service is ready")

    def add(
        self, request: AddTwoInts.Request, response: AddTwoInts.Response
    ) -> AddTwoInts.Response:
        response.sum = request.a + request.b
        self.get_logger().info(f"{request.a} + {request.b} = {response.sum}")
        return response


if __name__ == "__main__":
    with zbot.init():
        zbot.spin(Server())
