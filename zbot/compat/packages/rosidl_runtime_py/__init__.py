"""ROS 2's `rosidl_runtime_py`: messages as strings and dictionaries, and types by name."""

import importlib

from zbot.compat.rosidl import lookup
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

# This submodule and a function have the same name. Import the submodule first, because a later
# import of the submodule would replace the function.
importlib.import_module("rosidl_runtime_py.get_interfaces")
get_interfaces = lookup.get_interfaces
