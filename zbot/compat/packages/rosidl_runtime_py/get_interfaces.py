# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `get_action_interfaces` and `get_interface_packages` and `get_interface_path` and `get_interfaces` and `get_message_interfaces` and `get_service_interfaces`."""

from zbot.compat.rosidl.lookup import (
    get_action_interfaces,
    get_interface_packages,
    get_interface_path,
    get_interfaces,
    get_message_interfaces,
    get_service_interfaces,
)

__all__ = [
    "get_action_interfaces",
    "get_interface_packages",
    "get_interface_path",
    "get_interfaces",
    "get_message_interfaces",
    "get_service_interfaces",
]
