"""How many nodes of each name a launch has started."""

from zbot.launch.node_names import add_node_name as add_node_name
from zbot.launch.node_names import get_node_name_count as get_node_name_count
