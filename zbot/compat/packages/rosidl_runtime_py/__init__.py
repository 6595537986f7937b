"""ROS 2's `rosidl_runtime_py`: any message as text or dictionary, and back; types by name."""

import importlib

from zbot.interfaces import lookup
from zbot.interfaces.conversion import get_message_slot_types as get_message_slot_types
from zbot.interfaces.conversion import message_to_csv as message_to_csv
from zbot.interfaces.conversion import message_to_ordereddict as message_to_ordereddict
from zbot.interfaces.conversion import message_to_yaml as message_to_yaml
from zbot.interfaces.lookup import get_action_interfaces as get_action_interfaces
from zbot.interfaces.lookup import get_interface_packages as get_interface_packages
from zbot.interfaces.lookup import get_interface_path as get_interface_path
from zbot.interfaces.lookup import get_message_interfaces as get_message_interfaces
from zbot.interfaces.lookup import get_service_interfaces as get_service_interfaces
from zbot.interfaces.lookup import (
    import_message_from_namespaced_type as import_message_from_namespaced_type,
)
from zbot.interfaces.set_fields import set_message_fields as set_message_fields

# The submodule has the name of a function; imported later, it would take the function's place.
importlib.import_module("rosidl_runtime_py.get_interfaces")
get_interfaces = lookup.get_interfaces
