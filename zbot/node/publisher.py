"""Publishers, which encode a message and give it to Zenoh."""

from __future__ import annotations

import threading
from threading import get_ident
from time import time_ns
from typing import TYPE_CHECKING, Any, Generic, TypeVar

import zenoh

from zbot.errors import InvalidHandleError, WrongTypeError
from zbot.interfaces.same_type import is_message_of
from zbot.memory import LARGE_BYTES, keep_freed_memory
from zbot.names import ROSOUT_TOPIC
from zbot.node.endpoint import TopicEndpoint
from zbot.node.zenoh_declaration import can_block, declare_publisher, is_reliable
from zbot.process import blocked_put, fork, signals
from zbot.qos import DurabilityPolicy
from zbot.threads.wakeup import activity
from zbot.wire.attachment import GID_LENGTH, LAYOUT
from zbot.wire.errors import CodecError

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.context import Context
    from zbot.executor.callback_group import CallbackGroup
    from zbot.time import Duration
    from zbot.wire.tokens import EndpointToken

MsgT = TypeVar("MsgT")

_pack = LAYOUT.pack


class Publisher(TopicEndpoint, Generic[MsgT]):
    """Publishes messages of one type on one topic. `Node.create_publisher` creates publishers.

    `publish` may be called from any thread.

    Args:
        context: The context whose session sends the messages.
        msg_type: Message class.
        token: The publisher's liveliness token: its node, topic, type and profile.
        logger_name: Name of the node's logger.
        callback_group: Group of the callbacks for QoS events.
        is_announced: Whether the graph shows the publisher.
    """

    def __init__(
        self,
        context: Context,
        msg_type: type[MsgT],
        token: EndpointToken,
        *,
        logger_name: str,
        callback_group: CallbackGroup,
        is_announced: bool = True,
    ) -> None:
        self.msg_type = msg_type
        self.callback_group = callback_group
        self.event_handlers: list[Any] = []
        self._context = context
        self._token = token
        self._logger_name = logger_name
        self._encode: Callable[[Any], Any] = context.dialect.codec_for(msg_type).encode
        self.sent_count = 0  #: number of sent messages, and sequence number of the last one
        self._gid = token.gid
        self._next_number = context.graph.numbers.message_numbers(token)
        self._lock = threading.RLock()  # re-entrant, because a signal handler may use it
        # The thread that has sent all messages so far. It sends without the lock, because the lock
        # costs a tenth of a small message's latency.
        self._only_thread: int | None = None
        self._publisher: Any = declare_publisher(context, token)
        # Latched (transient local) messages do not go into shared memory, because the publisher's
        # cache of these messages would fill the memory.
        self._is_latched = token.qos.durability is DurabilityPolicy.TRANSIENT_LOCAL
        self._put = self._put_first
        self.is_putting = False  #: whether a thread is inside a put that can block
        self._send = self._send_at_once
        if can_block(token.qos):
            self._send = self._send_blocking
            blocked_put.publishers.add(self)
            blocked_put.watch_signals()
        self._announcement = context.graph.announce(token, is_visible=is_announced)

    @property
    def is_destroyed(self) -> bool:
        """Whether the publisher was destroyed."""
        return self._publisher is None

    @property
    def is_open(self) -> bool:
        """Whether `publish` can still send."""
        return self._publisher is not None and not self._context.is_closed

    @property
    def is_heard(self) -> bool:
        """Whether anyone subscribes to the topic now, also a command such as `zbot topic echo`.

        Commands do not announce their subscriptions, so `get_subscription_count` leaves them out.
        A transient local publisher is always heard: late subscribers will get its messages.
        """
        publisher = self._publisher  # another thread may destroy this publisher now
        if self._is_latched:
            return publisher is not None
        return publisher is not None and bool(publisher.matching_status.matching)

    def publish(self, msg: MsgT | bytes) -> None:
        """Send a message, or the bytes of a message in ROS 2's CDR or in zbot's encoding.

        The first call waits until the session has discovered the subscriptions that exist already,
        so that these subscriptions get the message. This takes at most 0.5 s and usually 2 ms. When
        the network queue is full, a publisher with a reliable keep-all profile waits. Other
        publishers drop the message.

        Raises:
            WrongTypeError: The message has another type than the topic.
            CodecError: A field of the message has a wrong value.
            InvalidHandleError: The publisher or its node was destroyed.
            NotInitializedError: The context was shut down.
        """
        if msg.__class__ is not self.msg_type:
            payload = self._from_other(msg)
        else:
            payload = self._encode(msg)
        if len(payload) >= LARGE_BYTES:
            keep_freed_memory()
            if not self._is_latched:
                payload = self._context.share(payload)
        try:
            if get_ident() == self._only_thread:
                self._send(payload)
            else:
                self._send_locked(payload)
        except zenoh.ZError:
            self._raise_if_closed()
            raise

    def _send_at_once(self, payload: Any) -> None:
        self.sent_count = number = self._next_number()
        activity.has_sent = True
        self._put(payload, attachment=_pack(number, time_ns(), GID_LENGTH, self._gid))

    def _send_blocking(self, payload: Any) -> None:
        self.is_putting = True
        try:
            self._send_at_once(payload)
        finally:
            self.is_putting = False

    def _send_locked(self, payload: Any) -> None:
        """Send the first message, or any message after a second thread has called `publish`.

        If several threads publish, all of them use the lock, so that sequence numbers stay in
        order. But when the second thread begins, the first thread may just be sending a message
        without the lock. The second thread's messages can overtake this one message.
        """
        with self._lock:
            self._only_thread = None
            self._send(payload)

    def _put_first(self, payload: Any, **options: Any) -> None:
        self._context.wait_for_peers()
        self._only_thread = get_ident()
        self._put = self._publisher.put
        self._put(payload, **options)

    def _from_other(self, msg: Any) -> Any:
        if isinstance(msg, bytes):
            return self._context.dialect.payload_of(msg, self.msg_type)
        # Another class of the same type may come from a real ROS 2 installation.
        if is_message_of(msg, self.msg_type):
            return self._encode(msg)
        raise WrongTypeError(
            f"{self.topic_name} carries {self._token.type_name}, "
            f"but publish() was given {_named(msg)}{self._right_call(msg)}"
        )

    def _right_call(self, msg: Any) -> str:
        """Return what to write for a class, or for the value of a message's only field."""
        if isinstance(msg, type):
            return f": write {msg.__name__}(), with parentheses"
        fields: dict[str, str] = getattr(self.msg_type, "get_fields_and_field_types", dict)()
        if len(fields) != 1 or not isinstance(msg, (str, bool, int, float)):
            return ""
        (field,) = fields
        try:
            self._encode(self.msg_type(**{field: msg}))
        except (CodecError, TypeError, ValueError):  # the value does not fit the field
            return ""
        return f": write publish({self.msg_type.__name__}({field}={msg!r}))"

    def _raise_if_closed(self) -> None:
        if self._publisher is None:
            raise InvalidHandleError(f"the publisher of {self.topic_name}") from None
        if self._context.session.is_closed():
            signals.raise_not_initialized("publish()")

    def get_subscription_count(self) -> int:
        """Return how many subscriptions of the same type the topic has in the whole domain."""
        subscriptions = self._context.graph.snapshot().subscriptions(self.topic_name)
        return sum(token.type_name == self._token.type_name for token in subscriptions)

    def wait_for_all_acked(self, timeout: Duration | None = None) -> bool:  # noqa: ARG002
        """Return whether all messages are known to have reached the reliable subscriptions.

        Subscriptions of other sessions send no acknowledgements. So the method does not wait, and
        ignores the timeout.

        Returns:
            True if the publisher is best effort, if it published nothing, or if all reliable
            subscriptions of the topic are in the publisher's own context. There, `publish` itself
            puts each message into the queues of the subscriptions. In all other cases, the result
            is False, because a message may have been lost.
        """
        if not self.sent_count or not is_reliable(self._token.qos):
            return True
        subscriptions = self._context.graph.snapshot().subscriptions(self.topic_name)
        return not any(
            is_reliable(token.qos) and token.zid != self._token.zid for token in subscriptions
        )

    def assert_liveliness(self) -> None:
        """Assert that the publisher is alive, for a `MANUAL_BY_TOPIC` profile."""
        for handler in self.event_handlers:
            handler.assert_liveliness()

    def destroy(self) -> None:
        """Leave the topic. This method may be called twice."""
        with self._lock:
            publisher, self._publisher = self._publisher, None
            self._put = self._refuse
        if publisher is None:
            return
        for handler in self.event_handlers:
            handler.destroy()
        if self._context.is_inherited:
            fork.keep(publisher)
        elif self._is_latched and not self._context.is_closed:
            self._keep(publisher)
        self._context.undeclare(self._announcement)
        # Zenoh undeclares a publisher when no object refers to the publisher and no other thread is
        # sending with it. So `undeclare()` is not called here. `undeclare()` of a latched publisher
        # keeps the GIL and waits at most 10 s for a thread of Zenoh, which may need the GIL itself.
        del publisher

    def _keep(self, publisher: Any) -> None:
        """Keep the Zenoh publisher for an equal one, if late subscribers get nothing wrong."""
        # Lines of a former node do no harm on /rosout, and most nodes write lines.
        if not self.sent_count or self.topic_name == ROSOUT_TOPIC:
            self._context.graph.numbers.keep(self._token, publisher)

    def leave_to_parent(self) -> None:
        """In a forked child, let `publish` raise an error."""
        fork.keep(self._publisher, self._put)
        self._lock = threading.RLock()  # a thread of the parent may hold the old lock
        self._put = self._refuse

    def _refuse(self, payload: Any, **_: Any) -> None:  # noqa: ARG002 - signature of Zenoh's put
        if self._context.is_inherited:
            self._context.require_valid(f"the publisher of {self.topic_name}")
        raise InvalidHandleError(f"the publisher of {self.topic_name}")


def _named(msg: Any) -> str:
    return (
        f"the class {msg.__name__}" if isinstance(msg, type) else f"{type(msg).__name__}: {msg!r}"
    )
