"""Classes by their names."""

from zbot.interfaces.lookup import get_action as get_action
from zbot.interfaces.lookup import get_interface as get_interface
from zbot.interfaces.lookup import get_message as get_message
from zbot.interfaces.lookup import get_service as get_service
from zbot.interfaces.lookup import is_action as is_action
from zbot.interfaces.lookup import is_message as is_message
from zbot.interfaces.lookup import is_service as is_service
