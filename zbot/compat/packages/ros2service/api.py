# Written by python -m zbot.compat.generator; do not edit.
"""Services."""

from zbot.compat.graph_listing import (
    get_service_class,
    get_service_names,
    get_service_names_and_types,
)

__all__ = [
    "get_service_class",
    "get_service_names",
    "get_service_names_and_types",
]
