# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `rosidl_runtime_py`: messages as strings and dictionaries, and types by name."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.compat.rosidl.conversion import (
    get_message_slot_types,
    message_to_csv,
    message_to_ordereddict,
    message_to_yaml,
)
from zbot.compat.rosidl.lookup import (
    get_action_interfaces,
    get_interface_packages,
    get_interface_path,
    get_message_interfaces,
    get_service_interfaces,
    import_message_from_namespaced_type,
)
from zbot.interfaces.set_fields import set_message_fields
from .get_interfaces import get_interfaces

__all__ = [
    "get_action_interfaces",
    "get_interface_packages",
    "get_interface_path",
    "get_interfaces",
    "get_message_interfaces",
    "get_message_slot_types",
    "get_service_interfaces",
    "import_message_from_namespaced_type",
    "message_to_csv",
    "message_to_ordereddict",
    "message_to_yaml",
    "set_message_fields",
]

if TYPE_CHECKING:
    from . import convert as convert
    from . import import_message as import_message
    from . import set_message as set_message
    from . import utilities as utilities
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "convert",
            "import_message",
            "set_message",
            "utilities",
        ),
    )[0]
