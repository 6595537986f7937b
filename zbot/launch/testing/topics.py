"""Class that waits for messages on several topics, like `WaitForTopics` of launch_testing_ros."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

from zbot.context import Context
from zbot.executor.spin_thread import SpinThread
from zbot.node.node import Node

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from typing_extensions import Self


class WaitForTopics:
    """Waits for messages on topics, with its own context, node and thread.

    Args:
        topic_tuples: Pairs of topic name and message class.
        timeout: The maximum duration of `wait()`, in seconds.
        messages_received_buffer_length: Number of messages to keep for each topic.
        trigger: Called with the node after the node has subscribed, e.g. to request messages.
        node_namespace: The namespace of the node.
    """

    def __init__(
        self,
        topic_tuples: Iterable[tuple[str, type[Any]]],
        timeout: float = 5.0,
        messages_received_buffer_length: int = 10,
        trigger: Callable[[Node], object] | None = None,
        node_namespace: str | None = None,
    ) -> None:
        self.topic_tuples, self.timeout = list(topic_tuples), timeout
        self._length = messages_received_buffer_length
        self._trigger = trigger
        self._messages: dict[str, list[Any]] = {name: [] for name, _ in self.topic_tuples}
        self._changed = threading.Condition()
        self._context = Context()
        self._context.init()
        self._node = Node("wait_for_topics", context=self._context, namespace=node_namespace)
        self._spinner = SpinThread(self._node, "wait for topics")
        self._is_listening = False

    def wait(self) -> bool:
        """Wait until each topic has a message. Return False if the timeout is over before that."""
        self._listen()
        with self._changed:
            return self._changed.wait_for(lambda: not self.topics_not_received(), self.timeout)

    def _listen(self) -> None:
        if self._is_listening:
            return
        self._is_listening = True
        for name, kind in self.topic_tuples:
            self._node.create_subscription(kind, name, self._keeper(name), 10)
        if self._trigger is not None:
            self._trigger(self._node)

    def _keeper(self, topic: str) -> Callable[[Any], None]:
        def keep(message: Any) -> None:
            with self._changed:
                kept = self._messages[topic]
                kept.append(message)
                del kept[: -self._length]
                self._changed.notify_all()

        return keep

    def topics_received(self) -> set[str]:
        """Return the topics with at least one message."""
        return {name for name, kept in self._messages.items() if kept}

    def topics_not_received(self) -> set[str]:
        """Return the topics without a message."""
        return {name for name, kept in self._messages.items() if not kept}

    def received_messages(self, topic_name: str) -> list[Any]:
        """Return the last messages of a topic. The oldest message is the first.

        Raises:
            KeyError: The constructor did not get this topic.
        """
        with self._changed:
            return list(self._messages[topic_name])

    def shutdown(self) -> None:
        """End the subscriptions and the thread. A second call does nothing."""
        self._spinner.stop()
        self._node.destroy_node()
        self._context.try_shutdown()

    def __enter__(self) -> Self:
        """Wait for the messages.

        Raises:
            AssertionError: A topic had no message in time.
        """
        if not self.wait():
            missing = ", ".join(sorted(self.topics_not_received()))
            self.shutdown()
            raise AssertionError(f"no message came within {self.timeout:g} s on {missing}")
        return self

    def __exit__(self, *exc_info: object) -> None:
        self.shutdown()
