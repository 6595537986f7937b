"""Outbox of a simulator: the messages of an instant, which are sent one after the other.

With a lockstep, the simulator must not send a message while it moves the world or goes through its
robots, because it handles requests while it waits. So all messages of a step are sent after it.
"""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.node.publisher import Publisher


class HeldPublisher:
    """Publisher whose messages wait in an outbox.

    Args:
        publisher: The publisher that sends them.
        outbox: The outbox.
    """

    def __init__(self, publisher: Publisher[Any], outbox: Outbox) -> None:
        self.publisher, self._outbox = publisher, outbox

    @property
    def topic_name(self) -> str:
        """The full name of the topic."""
        return self.publisher.topic_name

    @property
    def is_heard(self) -> bool:
        """Whether anyone subscribes to the topic, or the outbox wants its messages."""
        return self.publisher.is_heard or self._outbox.wants(self.topic_name)

    def publish(self, message: Any) -> None:
        """Put a message into the outbox."""
        self._outbox.waiting.append((self.publisher, message))

    def destroy(self) -> None:
        """Leave the topic."""
        self.publisher.destroy()


class Outbox:
    """Messages that wait.

    Attributes:
        waiting: The publishers and their messages, in order.
        wants: A function that says whether the messages of a topic are wanted, also if nobody
            subscribes.
        note: A function that gets the topic and the message of each message that is sent.
    """

    def __init__(self) -> None:
        self.waiting: deque[tuple[Publisher[Any], Any]] = deque()
        self.wants: Callable[[str], bool] = lambda _: False
        self.note: Callable[[str, Any], object] = lambda _topic, _message: None
        self._is_sending = False

    def send(self, settle: Callable[[], None]) -> None:
        """Send all messages.

        Args:
            settle: Called after each message that someone may have got.
        """
        if self._is_sending:
            return  # a request that was handled in `settle` has added messages
        self._is_sending = True
        try:
            while self.waiting:
                publisher, message = self.waiting.popleft()
                if not publisher.is_open:
                    continue  # its robot was removed
                self.note(publisher.topic_name, message)
                publisher.publish(message)
                if publisher.is_heard:
                    settle()
        finally:
            self._is_sending = False
