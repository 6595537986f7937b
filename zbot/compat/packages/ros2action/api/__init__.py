"""Actions."""

from zbot.compat.graph_listing import get_action_names, get_action_names_and_types
