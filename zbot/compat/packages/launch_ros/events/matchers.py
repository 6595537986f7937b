"""Whether an event is for a node."""

from zbot.launch.lifecycle_event import matches_node_name as matches_node_name
