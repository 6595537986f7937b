"""Checks of namespaces."""

from zbot.errors import InvalidNamespaceError as InvalidNamespaceException
from zbot.names import validate_namespace
