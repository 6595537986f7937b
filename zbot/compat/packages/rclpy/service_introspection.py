"""What is told of service calls."""

from zbot.service_introspection import ServiceIntrospectionState as ServiceIntrospectionState
