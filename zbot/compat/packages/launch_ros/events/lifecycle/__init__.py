"""Events of managed nodes."""

from zbot.launch.lifecycle_event import ChangeState, StateTransition, matches_node_name
