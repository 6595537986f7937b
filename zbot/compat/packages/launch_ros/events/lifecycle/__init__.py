"""What can happen to managed nodes."""

from zbot.launch.lifecycle_event import ChangeState as ChangeState
from zbot.launch.lifecycle_event import StateTransition as StateTransition
from zbot.launch.lifecycle_event import matches_node_name as matches_node_name
