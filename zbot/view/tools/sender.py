"""Sender of what tools publish, and of goals for a navigation."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.graph.snapshot import full_names
from zbot.names import SEND_GOAL
from zbot.wire.tokens import EntityKind

from nav2_msgs.action import NavigateToPose

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.observer.system import System

_ACTION = "nav2_msgs/action/NavigateToPose"


class Sender:
    """Publishers and action clients of the tools. Only one thread may use it.

    Args:
        system: The domain.
    """

    def __init__(self, system: System) -> None:
        self._system = system
        self._publishers: dict[tuple[str, str], Any] = {}
        self._clients: dict[str, Any] = {}
        self._readers: dict[str, Any] = {}

    def open(self, topic: str, type_name: str) -> None:
        """Create a publisher. Subscriptions then find it before the first message.

        Raises:
            ViewerError: The view may not publish.
            InvalidTopicNameError: The name is not valid in ROS 2.
        """
        if (topic, type_name) not in self._publishers:
            self._publishers[topic, type_name] = self._system.publisher(topic, type_name)

    def send(self, topic: str, type_name: str, message: Any) -> int:
        """Publish a message. Return the number of nodes that subscribe to the topic."""
        self.open(topic, type_name)
        self._publishers[topic, type_name].entity.publish(message)
        listeners = {*full_names(self._system.snapshot().subscriptions(topic))}
        return len(listeners - {self._system.node_name})

    def navigate(self, pose: Any, topic: str) -> list[str]:
        """Send a goal to each action server for navigation that does not listen to a topic.

        Args:
            pose: The goal, a `PoseStamped`.
            topic: The topic on which it was published too.

        Returns:
            The names of the actions.
        """
        graph = self._system.snapshot()
        listeners = {*full_names(graph.subscriptions(topic))}
        found = []
        for name, types in graph.actions(EntityKind.SERVICE):
            servers = full_names(graph.on(f"{name}{SEND_GOAL}", EntityKind.SERVICE))
            if _ACTION not in types or listeners.intersection(servers):
                continue
            if name not in self._clients:
                self._clients[name] = self._system.action_client(name, _ACTION)
            self._clients[name].entity.send_goal_async(NavigateToPose.Goal(pose=pose))
            found.append(name)
        return found

    def ask(
        self, service: str, type_name: str, request: Any, answer: Callable[[Any], object]
    ) -> None:
        """Call a service that changes nothing. The response comes in the node's thread.

        Without a server, nothing is done.
        """
        if service not in self._readers:
            self._readers[service] = self._system.reader(service, type_name)
        client = self._readers[service].entity
        if not client.service_is_ready():
            return

        def give(future: Any) -> None:
            if future.exception() is None and not future.cancelled():
                answer(future.result())

        client.call_async(request).add_done_callback(give)
