"""Events of nodes."""

from zbot.compat.submodules import submodules
from zbot.launch.lifecycle_event import matches_node_name

__getattr__ = submodules(__name__, "lifecycle")
