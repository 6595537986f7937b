# Written by python -m zbot.compat.generator; do not edit.
"""Modes of service introspection."""

from zbot.node.service_introspection import ServiceIntrospectionState

__all__ = [
    "ServiceIntrospectionState",
]
