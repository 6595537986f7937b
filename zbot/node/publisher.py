"""Publishers: a message becomes bytes once and goes to Zenoh."""

from __future__ import annotations

import itertools
import threading
from threading import get_ident
from time import time_ns
from typing import TYPE_CHECKING, Any, Generic, TypeVar

import zenoh

from zbot.errors import InvalidHandleError, NotInitializedError
from zbot.interfaces import type_name
from zbot.node.endpoint import TopicEndpoint
from zbot.node.errors import MessageTypeError
from zbot.process import blocked_put
from zbot.process.memory import LARGE_BYTES, keep_freed_memory
from zbot.qos import DurabilityPolicy, HistoryPolicy, ReliabilityPolicy
from zbot.wire.attachment import GID_LENGTH, LAYOUT
from zbot.wire.serialization import deserialize_message, is_cdr

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.context import Context
    from zbot.executor.callback_group import CallbackGroup
    from zbot.time import Duration
    from zbot.wire.tokens import EndpointToken

MsgT = TypeVar("MsgT")

_pack = LAYOUT.pack

# What a late subscriber may be missing is noticed this long after a burst, as in rmw_zenoh.
_HEARTBEAT_S = 0.5
#: Bound of a keep-all cache for late subscribers: Zenoh wants a number, and memory an end.
_KEEP_ALL_CACHE = 1000


class Publisher(TopicEndpoint, Generic[MsgT]):
    """Publishes messages of one type on one topic. Made by `Node.create_publisher`.

    `publish` may be called from any thread.

    Args:
        context: The session to publish through.
        msg_type: Message class.
        token: Who and where this publisher is.
        logger_name: The node's logger.
        callback_group: Where its events' callbacks run.
    """

    def __init__(
        self,
        context: Context,
        msg_type: type[MsgT],
        token: EndpointToken,
        *,
        logger_name: str,
        callback_group: CallbackGroup,
    ) -> None:
        self.msg_type = msg_type
        self.callback_group = callback_group
        self.event_handlers: list[Any] = []
        self._context = context
        self._token = token
        self._logger_name = logger_name
        self._encode: Callable[[Any], Any] = context.dialect.codec_for(msg_type).encode
        self.sent_count = 0  #: messages sent; the last one's sequence number
        self._gid = token.gid
        self._next_number = itertools.count(1).__next__
        self._lock = threading.RLock()  # re-entrant, for a signal's handler
        # A lock is a tenth of a small message's way, and most publishers are one thread's.
        self._only_thread: int | None = None
        self._publisher: Any = _declare(context, token)
        # What is kept for late subscribers would take the room of what is on its way.
        self._is_latched = token.qos.durability is DurabilityPolicy.TRANSIENT_LOCAL
        self._put = self._put_first
        self._liveliness = context.graph.announce(token)

    @property
    def is_destroyed(self) -> bool:
        """Whether it has left the topic."""
        return self._publisher is None

    @property
    def is_open(self) -> bool:
        """Whether `publish` can still send."""
        return self._publisher is not None and not self._context.is_closed

    def publish(self, msg: MsgT | bytes) -> None:
        """Send a message, or the bytes of one: ROS 2's CDR, or a payload of zbot's own form.

        The first call waits, at most 0.5 s and usually 2 ms, until the session has met the topic's
        subscribers, so that none that is already there misses it. With a reliable keep-all profile
        a full network queue blocks; with any other it drops.

        Raises:
            MessageTypeError: It is a message of another type.
            FieldTypeError: A field of it was given a wrong value behind its checks.
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
                self._send_in_turn(payload)
        except zenoh.ZError:
            self._explain()
            raise

    def _send(self, payload: Any) -> None:
        self.sent_count = number = self._next_number()
        self._put(payload, attachment=_pack(number, time_ns(), GID_LENGTH, self._gid))

    def _send_in_turn(self, payload: Any) -> None:
        """Send the first message, or from another thread than that one's.

        After the latter all threads wait for each other, to keep numbers in order. A put that the
        first thread has just begun may still be overtaken, once.
        """
        with self._lock:
            self._only_thread = None
            self._send(payload)

    def _put_first(self, payload: Any, **options: Any) -> None:
        self._context.meet()
        self._only_thread = get_ident()
        self._put = self._publisher.put
        self._put(payload, **options)

    def _from_other(self, msg: Any) -> Any:
        if isinstance(msg, bytes):
            # What begins like CDR is a serialized message; other bytes are the payload as it is.
            return self._encode(deserialize_message(msg, self.msg_type)) if is_cdr(msg) else msg
        # Two classes of one type: the other may come from a real ROS 2 installation.
        if isinstance(msg, self.msg_type) or self._is_same_type(msg):
            return self._encode(msg)
        raise MessageTypeError(self.topic_name, self._token.type_name, msg)

    def _is_same_type(self, msg: Any) -> bool:
        try:
            return type_name(type(msg)) == self._token.type_name
        except TypeError:
            return False

    def _explain(self) -> None:
        if self._publisher is None:
            raise InvalidHandleError(f"the publisher of {self.topic_name}") from None
        if self._context.session.is_closed():
            raise NotInitializedError("publish()") from None

    def get_subscription_count(self) -> int:
        """Return how many subscriptions the topic has in the whole domain."""
        return len(self._context.graph.snapshot().subscriptions(self.topic_name))

    def wait_for_all_acked(self, timeout: Duration | None = None) -> bool:  # noqa: ARG002
        """Return True: Zenoh hands reliable messages on link by link, without acks end to end."""
        return True

    def assert_liveliness(self) -> None:
        """Say that the publisher is alive, for a `MANUAL_BY_TOPIC` profile."""
        for handler in self.event_handlers:
            handler.assert_liveliness()

    def destroy(self) -> None:
        """Leave the topic; may be called twice."""
        with self._lock:
            publisher, self._publisher = self._publisher, None
            self._put = self._refuse
        if publisher is None:
            return
        for handler in self.event_handlers:
            handler.destroy()
        if not self._context.is_closed:
            self._liveliness.undeclare()
        # Zenoh undeclares what nobody holds, so another thread's put ends first. `undeclare()` of a
        # latched one would wait, up to 10 s and without letting Python run, for a thread of Zenoh's
        # that may be calling Python.
        del publisher

    def _refuse(self, payload: Any, **_: Any) -> None:  # noqa: ARG002 - stands in for Zenoh's put
        raise InvalidHandleError(f"the publisher of {self.topic_name}")


blocked_put.callers |= {Publisher._send.__code__, Publisher._put_first.__code__}  # noqa: SLF001


def _declare(context: Context, token: EndpointToken) -> Any:
    qos = token.qos
    reliable = qos.reliability is not ReliabilityPolicy.BEST_EFFORT
    keep_all = qos.history is HistoryPolicy.KEEP_ALL
    block = reliable and keep_all
    if block:
        blocked_put.watch_signals()
    options: dict[str, Any] = {
        "encoding": context.dialect.encoding(token.type_name),
        "reliability": zenoh.Reliability.RELIABLE if reliable else zenoh.Reliability.BEST_EFFORT,
        "congestion_control": (
            zenoh.CongestionControl.BLOCK if block else zenoh.CongestionControl.DROP
        ),
    }
    key = context.dialect.topic_key(context.get_domain_id(), token.name)
    if qos.durability is not DurabilityPolicy.TRANSIENT_LOCAL:
        return context.session.declare_publisher(key, **options)
    import zenoh.ext as advanced  # noqa: PLC0415 - only latched topics need it

    # Numbered samples need no timestamps, which every publisher of the session would pay for.
    options["sample_miss_detection"] = advanced.MissDetectionConfig(
        heartbeat=None, sporadic_heartbeat=_HEARTBEAT_S if reliable else None
    )
    depth = _KEEP_ALL_CACHE if keep_all else max(qos.depth, 1)
    return advanced.declare_advanced_publisher(
        context.session,
        key,
        cache=advanced.CacheConfig(depth),
        publisher_detection=True,
        **options,
    )
