"""Services."""

from zbot.compat.graph_listing import (
    get_service_class,
    get_service_names,
    get_service_names_and_types,
)
