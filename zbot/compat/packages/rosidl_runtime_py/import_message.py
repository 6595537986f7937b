# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `import_message_from_namespaced_type`."""

from zbot.compat.rosidl.lookup import import_message_from_namespaced_type

__all__ = [
    "import_message_from_namespaced_type",
]
