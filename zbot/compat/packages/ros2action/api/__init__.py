"""Actions."""

from zbot.compat.graph_listing import get_action_names as get_action_names
from zbot.compat.graph_listing import get_action_names_and_types as get_action_names_and_types
