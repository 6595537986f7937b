"""Functions that count the nodes of each name in a launch."""

from zbot.launch.node_names import add_node_name, get_node_name_count
