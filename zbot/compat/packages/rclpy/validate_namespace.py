# Written by python -m zbot.compat.generator; do not edit.
"""Checks of namespaces."""

from zbot.errors import InvalidNamespaceError as InvalidNamespaceException
from zbot.names import validate_namespace

__all__ = [
    "InvalidNamespaceException",
    "validate_namespace",
]
