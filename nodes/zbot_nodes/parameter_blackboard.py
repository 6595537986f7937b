"""Accept all parameters without declaring them, to try `zbot param`.

Run:  zbot run parameter_blackboard --ros-args -p colour:=green
Set:  zbot param set /parameter_blackboard size 3
Look: zbot param dump /parameter_blackboard
"""

import zbot


class ParameterBlackboard(zbot.Node):
    """Accepts every parameter. Parameters of the command line and of files are set at the start."""

    def __init__(self) -> None:
        super().__init__(
            "parameter_blackboard",
            allow_undeclared_parameters=True,
            automatically_declare_parameters_from_overrides=True,
        )
        count = len(self.list_parameters([], 0).names)
        self.get_logger().info(f"{self.get_fully_qualified_name()} has {count} parameters already")


def main() -> None:
    """Run until Ctrl-C."""
    with zbot.init():
        zbot.spin(ParameterBlackboard())


if __name__ == "__main__":
    main()
