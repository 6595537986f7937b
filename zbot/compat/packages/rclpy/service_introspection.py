"""Modes of service introspection."""

from zbot.node.service_introspection import ServiceIntrospectionState
