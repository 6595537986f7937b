"""Services."""

from zbot.compat.graph_listing import get_service_class as get_service_class
from zbot.compat.graph_listing import get_service_names as get_service_names
from zbot.compat.graph_listing import get_service_names_and_types as get_service_names_and_types
