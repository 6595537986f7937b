"""Topics."""

from zbot.compat.graph_listing import get_msg_class as get_msg_class
from zbot.compat.graph_listing import get_topic_names as get_topic_names
from zbot.compat.graph_listing import get_topic_names_and_types as get_topic_names_and_types
