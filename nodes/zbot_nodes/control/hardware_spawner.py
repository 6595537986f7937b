"""Activate or configure hardware components, and exit.

Run: zbot run controller_manager hardware_spawner NAME... --activate [-c controller_manager]
     zbot run controller_manager hardware_spawner NAME... --configure
"""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING

import zbot
from zbot.libraries import controller_manager
from zbot.parameters.ros_args import remove_ros_args
from zbot_nodes.control.controller import ControllerError

from lifecycle_msgs.msg import State

if TYPE_CHECKING:
    from collections.abc import Sequence


def read_arguments(words: Sequence[str]) -> argparse.Namespace:
    """Read a command line with the options of ROS 2's hardware_spawner."""
    parser = argparse.ArgumentParser(
        prog="hardware_spawner", description="Activate or configure hardware components"
    )
    parser.add_argument("hardware_component_names", nargs="+")
    parser.add_argument("-c", "--controller-manager", default="controller_manager")
    parser.add_argument("--controller-manager-timeout", type=float, default=0.0)
    actions = parser.add_mutually_exclusive_group(required=True)
    actions.add_argument("--activate", action="store_true")
    actions.add_argument("--configure", action="store_true")
    return parser.parse_args(remove_ros_args(["hardware_spawner", *words])[1:])


def spawn(node: zbot.Node, options: argparse.Namespace) -> None:
    """Bring each hardware component to the wanted state.

    Raises:
        ControllerError: The manager refuses.
        ServiceNotFoundError: The manager is not there in time.
        WrongStateError: The manager does not answer.
    """
    wanted = State(id=State.PRIMARY_STATE_INACTIVE, label="inactive")
    if options.activate:
        wanted = State(id=State.PRIMARY_STATE_ACTIVE, label="active")
    for name in options.hardware_component_names:
        answer = controller_manager.set_hardware_component_state(
            node, options.controller_manager, name, wanted, options.controller_manager_timeout
        )
        if not answer.ok:
            raise ControllerError(
                f"the hardware component '{name}' did not become {wanted.label}: the log of the "
                "manager has the reason"
            )
        node.get_logger().info(f"Hardware component '{name}' is {answer.state.label}")


def main() -> None:
    """Change the states."""
    options = read_arguments(sys.argv[1:])
    with zbot.init():
        try:
            spawn(zbot.Node("hardware_spawner"), options)
        except zbot.ZbotError as error:
            sys.exit(f"error: {error}")


if __name__ == "__main__":
    main()
