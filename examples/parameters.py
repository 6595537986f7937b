"""Parameter: a setting that is given at the start, and can be changed while the node runs.

Run: zbot run examples/parameters.py --ros-args -p text:=hi
"""

import zbot


class Greeter(zbot.Node):
    def __init__(self) -> None:
        super().__init__("greeter")
        self.declare_parameter("text", "hello")
        self.create_timer(1.0, self.greet)

    def greet(self) -> None:
        self.get_logger().info(self.get_parameter("text").value)


if __name__ == "__main__":
    with zbot.init():
        zbot.spin(Greeter())
