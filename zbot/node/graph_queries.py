"""Graph queries of a node: names, types, endpoints and counts."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.errors import InvalidNameError
from zbot.graph.endpoint_info import TopicEndpointInfo
from zbot.graph.snapshot import full_names
from zbot.names import fully_qualified
from zbot.node.errors import UnknownNodeError
from zbot.wire.tokens import EndpointToken, EntityKind

if TYPE_CHECKING:
    from zbot.context import Context
    from zbot.graph.snapshot import NamesAndTypes


class GraphQueries:
    """rclpy's graph methods. The subclass has a context and resolves names."""

    @property
    def context(self) -> Context:
        """The context whose graph is queried."""
        raise NotImplementedError

    def resolve_topic_name(self, topic: str, *, only_expand: bool = False) -> str:
        """Return the full name of a topic."""
        raise NotImplementedError

    def resolve_service_name(self, service: str, *, only_expand: bool = False) -> str:
        """Return the full name of a service."""
        raise NotImplementedError

    def get_node_names(self) -> list[str]:
        """Return the base names of all nodes."""
        return [node.node for node in self.context.graph.snapshot().nodes]

    def get_fully_qualified_node_names(self) -> list[str]:
        """Return the full names of all nodes."""
        return full_names(self.context.graph.snapshot().nodes)

    def get_node_names_and_namespaces(self) -> list[tuple[str, str]]:
        """Return the name and the namespace of each node."""
        return [(node.node, node.namespace) for node in self.context.graph.snapshot().nodes]

    def get_node_names_and_namespaces_with_enclaves(self) -> list[tuple[str, str, str]]:
        """Return the name, the namespace and the enclave of each node."""
        nodes = self.context.graph.snapshot().nodes
        return [(node.node, node.namespace, node.enclave) for node in nodes]

    def get_topic_names_and_types(self, no_demangle: bool = False) -> NamesAndTypes:  # noqa: ARG002
        """Return every topic with its types."""
        return self.context.graph.snapshot().topics()

    def get_service_names_and_types(self) -> NamesAndTypes:
        """Return every service with its types."""
        return self.context.graph.snapshot().services()

    def get_publisher_names_and_types_by_node(
        self,
        node_name: str,
        node_namespace: str,
        no_demangle: bool = False,  # noqa: ARG002
    ) -> NamesAndTypes:
        """Return the topics that a node publishes."""
        return self._zbot_of_node(EntityKind.PUBLISHER, node_name, node_namespace)

    def get_subscriber_names_and_types_by_node(
        self,
        node_name: str,
        node_namespace: str,
        no_demangle: bool = False,  # noqa: ARG002
    ) -> NamesAndTypes:
        """Return the topics that a node subscribes to."""
        return self._zbot_of_node(EntityKind.SUBSCRIPTION, node_name, node_namespace)

    def get_service_names_and_types_by_node(
        self, node_name: str, node_namespace: str
    ) -> NamesAndTypes:
        """Return the services that a node serves."""
        return self._zbot_of_node(EntityKind.SERVICE, node_name, node_namespace)

    def get_client_names_and_types_by_node(
        self, node_name: str, node_namespace: str
    ) -> NamesAndTypes:
        """Return the services that a node is a client of."""
        return self._zbot_of_node(EntityKind.CLIENT, node_name, node_namespace)

    def _zbot_of_node(self, kind: EntityKind, name: str, namespace: str) -> NamesAndTypes:
        snapshot = self.context.graph.snapshot()
        full = fully_qualified(namespace, name)
        if full not in full_names(snapshot.nodes):
            raise UnknownNodeError(full, full_names(snapshot.nodes))
        return snapshot.names_and_types(kind, node=full)

    def get_publishers_info_by_topic(
        self,
        topic_name: str,
        no_mangle: bool = False,  # noqa: ARG002
    ) -> list[TopicEndpointInfo]:
        """Return the node, type and quality of service of each publisher of a topic."""
        return self._zbot_infos(EntityKind.PUBLISHER, topic_name)

    def get_subscriptions_info_by_topic(
        self,
        topic_name: str,
        no_mangle: bool = False,  # noqa: ARG002
    ) -> list[TopicEndpointInfo]:
        """Return the node, type and quality of service of each subscription of a topic."""
        return self._zbot_infos(EntityKind.SUBSCRIPTION, topic_name)

    def _zbot_on(self, kind: EntityKind, name: str) -> list[EndpointToken]:
        is_service = kind in {EntityKind.SERVICE, EntityKind.CLIENT}
        try:
            full = self.resolve_service_name(name) if is_service else self.resolve_topic_name(name)
        except InvalidNameError as error:
            # rclpy's sentence for a query differs from that for a new entity.
            error.args = (f"{error.name_type} {error.name!r} is invalid: {error.error_msg}",)
            raise
        return self.context.graph.snapshot().on(full, kind)

    def _zbot_infos(self, kind: EntityKind, topic: str) -> list[TopicEndpointInfo]:
        return [TopicEndpointInfo.of(token) for token in self._zbot_on(kind, topic)]

    def count_publishers(self, topic_name: str) -> int:
        """Return how many publishers a topic has."""
        return len(self._zbot_on(EntityKind.PUBLISHER, topic_name))

    def count_subscribers(self, topic_name: str) -> int:
        """Return how many subscriptions a topic has."""
        return len(self._zbot_on(EntityKind.SUBSCRIPTION, topic_name))

    def count_services(self, service_name: str) -> int:
        """Return how many servers a service has."""
        return len(self._zbot_on(EntityKind.SERVICE, service_name))

    def count_clients(self, service_name: str) -> int:
        """Return how many clients a service has."""
        return len(self._zbot_on(EntityKind.CLIENT, service_name))

    def wait_for_node(self, fully_qualified_node_name: str, timeout: float) -> bool:
        """Wait until a node exists.

        Return `False` after `timeout` seconds, or when the context ends.
        """
        wanted = "/" + fully_qualified_node_name.lstrip("/")
        return self.context.graph.wait_for(
            lambda snapshot: wanted in full_names(snapshot.nodes), timeout
        )
