"""Which types there are."""

from zbot.interfaces.lookup import get_action_interfaces as get_action_interfaces
from zbot.interfaces.lookup import get_interface_packages as get_interface_packages
from zbot.interfaces.lookup import get_interface_path as get_interface_path
from zbot.interfaces.lookup import get_interfaces as get_interfaces
from zbot.interfaces.lookup import get_message_interfaces as get_message_interfaces
from zbot.interfaces.lookup import get_service_interfaces as get_service_interfaces
