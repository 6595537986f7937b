"""Ask a server for the sum of two integers, and log its response.

Run:  zbot run add_two_ints_client 2 3
Asks: add_two_ints (example_interfaces/srv/AddTwoInts)
"""

import argparse
import sys

import zbot
from zbot.parameters.ros_args import remove_ros_args

from example_interfaces.srv import AddTwoInts


class AddTwoIntsClient(zbot.Node):
    """Calls the service as soon as it has a server."""

    def __init__(self) -> None:
        super().__init__("add_two_ints_client")
        self.cli = self.create_client(AddTwoInts, "add_two_ints")
        while not self.cli.wait_for_service(timeout_sec=1.0):
            self.get_logger().info("service not available, waiting again...")

    def send_request(self, a: int, b: int) -> AddTwoInts.Response:
        """Return the server's answer."""
        response: AddTwoInts.Response = self.cli.call(AddTwoInts.Request(a=a, b=b))
        return response


def main() -> None:
    """Ask once, for the numbers of the command line or for 2 + 3."""
    parser = argparse.ArgumentParser(prog="add_two_ints_client", description=__doc__)
    parser.add_argument("a", type=int, nargs="?", default=2)
    parser.add_argument("b", type=int, nargs="?", default=3)
    numbers = parser.parse_args(remove_ros_args(sys.argv)[1:])
    with zbot.init():
        client = AddTwoIntsClient()
        response = client.send_request(numbers.a, numbers.b)
        client.get_logger().info(
            f"Result of add_two_ints: for {numbers.a} + {numbers.b} = {response.sum}"
        )


if __name__ == "__main__":
    main()
