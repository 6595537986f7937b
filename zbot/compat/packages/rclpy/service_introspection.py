"""What is told of service calls."""

from zbot.node.service_introspection import ServiceIntrospectionState as ServiceIntrospectionState
