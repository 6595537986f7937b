"""Function that checks whether an event is for a node."""

from zbot.launch.lifecycle_event import matches_node_name
