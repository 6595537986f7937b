"""Publish the axes and buttons of a gamepad, with the parameters of the package joy_linux.

Run:        zbot run joy_linux joy_linux_node
Parameters: dev ("/dev/input/js0"; its last digits are the gamepad's number), dev_name (""),
            dev_ff ("/dev/input/event0"), coalesce_interval (0.001 s), default_trig_val (false);
            deadzone, autorepeat_rate and sticky_buttons as for joy_node
Topics:     those of joy_node
"""

from __future__ import annotations

import re

from zbot_nodes.driving.joy_node import JoyNode, stick_shown
from zbot_nodes.startup.program import run_node


class JoyLinuxNode(JoyNode):
    """Reads the gamepad of a device file."""

    def declare_device(self) -> None:
        """Declare the parameters that select the gamepad."""
        self.declare_parameter("dev", "/dev/input/js0")
        self.declare_parameter("dev_name", "")
        self.declare_parameter("dev_ff", "/dev/input/event0")
        self.declare_parameter("coalesce_interval", 0.001)
        self.declare_parameter("default_trig_val", False)

    def device(self) -> tuple[int, str]:
        """Return the number and the name of the gamepad."""
        number = re.search(r"(\d+)$", str(self.get_parameter("dev").value))
        return int(number[1]) if number else 0, str(self.get_parameter("dev_name").value)


def main() -> None:
    """Run until Ctrl-C."""
    run_node(JoyLinuxNode, around=stick_shown)


if __name__ == "__main__":
    main()
