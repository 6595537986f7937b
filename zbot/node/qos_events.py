"""Events of quality of service: matched, type clash, deadline, liveliness, message lost.

Zenoh enforces none of them, so they are found here: matches from the graph, losses from the numbers
that messages carry, deadlines and leases with a timer that looks whether anything was sent since.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING, Any, TypeAlias

from zbot.executor.clock import Clock
from zbot.executor.ready_queue import ReadyQueue
from zbot.executor.timer import Timer
from zbot.qos import LivelinessPolicy, QoSPolicyKind
from zbot.time import ClockType
from zbot.transport.handle import Handle
from zbot.wire.tokens import EndpointToken, EntityKind

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.executor.callback_group import CallbackGroup
    from zbot.graph.snapshot import Graph, Token
    from zbot.time import Duration

_INFINITE_NS = 2**63 - 1


class QoSPublisherEventType(Enum):
    """What can happen to a publisher (rclpy's names and numbers)."""

    RCL_PUBLISHER_OFFERED_DEADLINE_MISSED = 0
    RCL_PUBLISHER_LIVELINESS_LOST = 1
    RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS = 2
    RCL_PUBLISHER_INCOMPATIBLE_TYPE = 3
    RCL_PUBLISHER_MATCHED = 4


class QoSSubscriptionEventType(Enum):
    """What can happen to a subscription (rclpy's names and numbers)."""

    RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED = 0
    RCL_SUBSCRIPTION_LIVELINESS_CHANGED = 1
    RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS = 2
    RCL_SUBSCRIPTION_MESSAGE_LOST = 3
    RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE = 4
    RCL_SUBSCRIPTION_MATCHED = 5


_P, _S = QoSPublisherEventType, QoSSubscriptionEventType
EventKind: TypeAlias = QoSPublisherEventType | QoSSubscriptionEventType


@dataclass(frozen=True)
class QoSCountInfo:
    """How often something happened, in all and since the last event."""

    total_count: int
    total_count_change: int


class QoSOfferedDeadlineMissedInfo(QoSCountInfo):
    """A publisher sent nothing for a whole deadline period."""


class QoSRequestedDeadlineMissedInfo(QoSCountInfo):
    """A subscription got nothing for a whole deadline period."""


class QoSLivelinessLostInfo(QoSCountInfo):
    """A publisher did not say in time that it is alive."""


class QoSMessageLostInfo(QoSCountInfo):
    """Messages were published and never came out of the queue."""


class IncompatibleTypeInfo(QoSCountInfo):
    """Somebody uses the topic with another type."""


@dataclass(frozen=True)
class QoSRequestedIncompatibleQoSInfo(QoSCountInfo):
    """Never sent: no two profiles are incompatible in zbot."""

    last_policy_kind: int


QoSOfferedIncompatibleQoSInfo = QoSRequestedIncompatibleQoSInfo


@dataclass(frozen=True)
class QoSMatchedInfo(QoSCountInfo):
    """How many partners came in all, and how many there are now."""

    current_count: int
    current_count_change: int


QoSPublisherMatchedInfo = QoSMatchedInfo
QoSSubscriptionMatchedInfo = QoSMatchedInfo


@dataclass(frozen=True)
class QoSLivelinessChangedInfo:
    """How many publishers are alive, and how many are gone."""

    alive_count: int
    not_alive_count: int
    alive_count_change: int
    not_alive_count_change: int


class EventHandler:
    """Runs one event's callback in the node's executor.

    Args:
        callback: Takes the event's info.
        callback_group: Decides beside what it may run.
        ready_queue: The node's way to its executor.
    """

    def __init__(
        self, callback: Callable[[Any], Any], callback_group: CallbackGroup, ready_queue: ReadyQueue
    ) -> None:
        self.callback = callback
        self.callback_group = callback_group
        self.ready_queue = ready_queue
        self._infos: deque[Any] = deque()
        ready_queue.add(self)

    @property
    def due_ns(self) -> int | None:
        """When it wants to look for an event by itself (monotonic clock, nanoseconds)."""
        return None

    def tell(self, info: Any) -> None:
        """Queue an event; from any thread."""
        self._infos.append(info)
        self.ready_queue.post(self)

    def take(self) -> Any | None:
        """Return the oldest event, if any."""
        return self._infos.popleft() if self._infos else None

    @property
    def has_work(self) -> bool:
        """Whether an event waits."""
        return bool(self._infos)

    def execute(self, info: Any) -> Any:
        """Call the callback."""
        return self.callback(info)

    def assert_liveliness(self) -> None:
        """Note that the publisher said it is alive."""

    def destroy(self) -> None:
        """Call the callback no more."""
        self.ready_queue.remove(self)
        self._infos.clear()


class _NeverHandler(EventHandler):
    """Stands for an event that cannot come, such as one of two incompatible profiles."""

    def __init__(
        self, callback: Callable[[Any], Any], callback_group: CallbackGroup, ready_queue: ReadyQueue
    ) -> None:
        self.callback, self.callback_group, self.ready_queue = callback, callback_group, ready_queue
        self._infos = deque()  # and unknown to the executor, which it never needs


class _PartnerHandler(EventHandler):
    """Follows the other side's endpoints on the topic."""

    def __init__(
        self,
        callback: Callable[[Any], Any],
        callback_group: CallbackGroup,
        ready_queue: ReadyQueue,
        *,
        own: EndpointToken,
        graph: Graph,
    ) -> None:
        super().__init__(callback, callback_group, ready_queue)
        published = own.kind is EntityKind.PUBLISHER
        self._partner = EntityKind.SUBSCRIPTION if published else EntityKind.PUBLISHER
        self._own = own
        self._graph = graph
        self._known: set[str] = set()
        self._total = 0
        graph.add_listener(self._on_change)

    def _concerns(self, token: EndpointToken) -> bool:
        return token.type_name == self._own.type_name

    def _on_change(self, token: Token, appeared: bool) -> None:
        if not isinstance(token, EndpointToken) or token.kind is not self._partner:
            return
        if token.name != self._own.name or not self._concerns(token):
            return
        if appeared == (token.key in self._known):
            return
        (self._known.add if appeared else self._known.discard)(token.key)
        self._total += appeared
        self._report(appeared=appeared)

    def _report(self, *, appeared: bool) -> None:
        self.tell(
            QoSMatchedInfo(self._total, int(appeared), len(self._known), 1 if appeared else -1)
        )

    def destroy(self) -> None:
        self._graph.remove_listener(self._on_change)
        super().destroy()


class _LivelinessChangedHandler(_PartnerHandler):
    def _report(self, *, appeared: bool) -> None:
        change = 1 if appeared else -1
        gone = self._total - len(self._known)
        self.tell(QoSLivelinessChangedInfo(len(self._known), gone, change, 0 if appeared else 1))


class _TypeClashHandler(_PartnerHandler):
    def _concerns(self, token: EndpointToken) -> bool:
        return token.type_name != self._own.type_name

    def _report(self, *, appeared: bool) -> None:
        if appeared:
            self.tell(IncompatibleTypeInfo(self._total, 1))


class _LossHandler(EventHandler):
    _total = 0

    def add(self, missing: int) -> None:
        self._total += missing
        self.tell(QoSMessageLostInfo(self._total, missing))


class _SilenceHandler(EventHandler):
    """Tells when an endpoint's counter stands still for a whole period."""

    def __init__(
        self,
        callback: Callable[[Any], Any],
        callback_group: CallbackGroup,
        ready_queue: ReadyQueue,
        *,
        period: Duration,
        count: Callable[[], int],
        info: type[QoSCountInfo],
    ) -> None:
        self._count = count
        self._info = info
        self._last = count()
        self._total = 0
        steady = Clock(clock_type=ClockType.STEADY_TIME)
        self._timer = Timer(None, callback_group, period.nanoseconds, steady, ready_queue)
        super().__init__(callback, callback_group, ready_queue)  # last: it may be asked at once

    @property
    def due_ns(self) -> int | None:
        return self._timer.due_ns

    @property
    def has_work(self) -> bool:
        self._look()
        return super().has_work

    def take(self) -> Any | None:
        self._look()
        return super().take()

    def _look(self) -> None:
        if self._timer.take() is None:
            return
        count = self._count()
        if self._is_silent(count):
            self._total += 1
            self.tell(self._info(self._total, 1))
        self._last = count

    def _is_silent(self, count: int) -> bool:
        return count == self._last

    def destroy(self) -> None:
        self._timer.destroy()
        super().destroy()


class _LeaseHandler(_SilenceHandler):
    """Tells once when a publisher neither published nor said that it is alive, until it does."""

    _was_asserted = False
    _is_lost = False

    def assert_liveliness(self) -> None:
        self._was_asserted = True

    def _is_silent(self, count: int) -> bool:
        was_lost = self._is_lost
        self._is_lost = super()._is_silent(count) and not self._was_asserted
        self._was_asserted = False
        return self._is_lost and not was_lost


def _is_finite(period: Duration) -> bool:
    return 0 < period.nanoseconds < _INFINITE_NS


def _make_handler(
    kind: EventKind,
    callback: Callable[[Any], Any],
    endpoint: Any,
    ready_queue: ReadyQueue,
    graph: Graph,
) -> EventHandler:
    """Return what follows one kind of event of a publisher or subscription."""
    group, own = endpoint.callback_group, endpoint.token
    if kind in _PARTNERS:
        return _PARTNERS[kind](callback, group, ready_queue, own=own, graph=graph)
    if kind is _S.RCL_SUBSCRIPTION_MESSAGE_LOST:
        loss = _LossHandler(callback, group, ready_queue)
        endpoint.report_losses_to(loss.add)
        return loss
    period, silence = own.qos.deadline, _SilenceHandler
    if kind is _P.RCL_PUBLISHER_LIVELINESS_LOST:
        period, silence = own.qos.liveliness_lease_duration, _LeaseHandler
        if own.qos.liveliness is not LivelinessPolicy.MANUAL_BY_TOPIC:
            return _NeverHandler(callback, group, ready_queue)
    if kind in _INCOMPATIBLE_QOS or not _is_finite(period):
        return _NeverHandler(callback, group, ready_queue)

    def count() -> int:
        messages: int = endpoint.sent_count if kind in _P else endpoint.received_count
        return messages

    info = type(_NOTHING[kind])
    return silence(callback, group, ready_queue, period=period, count=count, info=info)


_PARTNERS: dict[EventKind, type[_PartnerHandler]] = {
    _P.RCL_PUBLISHER_INCOMPATIBLE_TYPE: _TypeClashHandler,
    _P.RCL_PUBLISHER_MATCHED: _PartnerHandler,
    _S.RCL_SUBSCRIPTION_LIVELINESS_CHANGED: _LivelinessChangedHandler,
    _S.RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE: _TypeClashHandler,
    _S.RCL_SUBSCRIPTION_MATCHED: _PartnerHandler,
}
_INCOMPATIBLE_QOS: tuple[EventKind, ...] = (
    _P.RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS,
    _S.RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS,
)
# What ROS 2 has a callback of its own for, unless told otherwise.
_DEFAULTS: tuple[EventKind, ...] = (
    *_INCOMPATIBLE_QOS,
    _P.RCL_PUBLISHER_INCOMPATIBLE_TYPE,
    _S.RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE,
)
#: The info of each kind before anything happened.
_NOTHING: dict[EventKind, Any] = {
    _P.RCL_PUBLISHER_OFFERED_DEADLINE_MISSED: QoSOfferedDeadlineMissedInfo(0, 0),
    _P.RCL_PUBLISHER_LIVELINESS_LOST: QoSLivelinessLostInfo(0, 0),
    _P.RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS: QoSOfferedIncompatibleQoSInfo(
        0, 0, QoSPolicyKind.INVALID
    ),
    _P.RCL_PUBLISHER_INCOMPATIBLE_TYPE: IncompatibleTypeInfo(0, 0),
    _P.RCL_PUBLISHER_MATCHED: QoSMatchedInfo(0, 0, 0, 0),
    _S.RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED: QoSRequestedDeadlineMissedInfo(0, 0),
    _S.RCL_SUBSCRIPTION_LIVELINESS_CHANGED: QoSLivelinessChangedInfo(0, 0, 0, 0),
    _S.RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS: QoSRequestedIncompatibleQoSInfo(
        0, 0, QoSPolicyKind.INVALID
    ),
    _S.RCL_SUBSCRIPTION_MESSAGE_LOST: QoSMessageLostInfo(0, 0),
    _S.RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE: IncompatibleTypeInfo(0, 0),
    _S.RCL_SUBSCRIPTION_MATCHED: QoSMatchedInfo(0, 0, 0, 0),
}


def _ignore(info: object) -> None:
    """Stand for the callback of an event that is taken by hand, or told by zbot's own notices."""


class EventHandle(Handle[EventHandler]):
    """One kind of event to wait for with a `WaitSet`, and to take from there.

    Args:
        parent: The publisher's or subscription's handle.
        kind: Which event.
    """

    def __init__(self, parent: Handle[Any], kind: EventKind) -> None:
        endpoint = parent.entity
        graph = endpoint.context.graph
        super().__init__(_make_handler(kind, _ignore, endpoint, ReadyQueue(), graph))
        self._nothing = _NOTHING[kind]

    def take_event(self) -> Any:
        """Return the oldest event's info; counts of 0 if there is none."""
        info = self.entity.take()
        return self._nothing if info is None else info


class _EventCallbacks:
    """What publishers' and subscriptions' callbacks have in common."""

    use_default_callbacks: bool

    def _by_kind(self) -> dict[EventKind, Callable[[Any], Any] | None]:
        raise NotImplementedError

    def attach(self, endpoint: Any, ready_queue: ReadyQueue, graph: Graph) -> None:
        """Make the handlers of a publisher or subscription; its `destroy()` ends them."""
        for kind, callback in self._by_kind().items():
            if callback is not None:
                handler = _make_handler(kind, callback, endpoint, ready_queue, graph)
            elif self.use_default_callbacks and kind in _DEFAULTS:
                # Type clashes are told of all endpoints alike, in one place: zbot.node.diagnostics.
                handler = _NeverHandler(_ignore, endpoint.callback_group, ready_queue)
            else:
                continue
            endpoint.event_handlers.append(handler)


class PublisherEventCallbacks(_EventCallbacks):
    """What a publisher wants to hear; each callback takes the event's info.

    Args:
        deadline: Nothing was published for a deadline period.
        liveliness: The lease of a `MANUAL_BY_TOPIC` profile ran out.
        incompatible_qos: Accepted and never called: no two profiles are incompatible.
        incompatible_type: A subscription has another type.
        matched: A subscription came or went.
        use_default_callbacks: Count handlers as rclpy does; type clashes are always logged.
    """

    def __init__(
        self,
        *,
        deadline: Callable[[QoSOfferedDeadlineMissedInfo], Any] | None = None,
        liveliness: Callable[[QoSLivelinessLostInfo], Any] | None = None,
        incompatible_qos: Callable[[QoSOfferedIncompatibleQoSInfo], Any] | None = None,
        incompatible_type: Callable[[IncompatibleTypeInfo], Any] | None = None,
        matched: Callable[[QoSPublisherMatchedInfo], Any] | None = None,
        use_default_callbacks: bool = True,
    ) -> None:
        self.deadline = deadline
        self.liveliness = liveliness
        self.incompatible_qos = incompatible_qos
        self.incompatible_type = incompatible_type
        self.matched = matched
        self.use_default_callbacks = use_default_callbacks

    def _by_kind(self) -> dict[EventKind, Callable[[Any], Any] | None]:
        return {
            _P.RCL_PUBLISHER_OFFERED_DEADLINE_MISSED: self.deadline,
            _P.RCL_PUBLISHER_LIVELINESS_LOST: self.liveliness,
            _P.RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS: self.incompatible_qos,
            _P.RCL_PUBLISHER_INCOMPATIBLE_TYPE: self.incompatible_type,
            _P.RCL_PUBLISHER_MATCHED: self.matched,
        }


class SubscriptionEventCallbacks(_EventCallbacks):
    """What a subscription wants to hear; each callback takes the event's info.

    Args:
        deadline: Nothing came for a deadline period.
        incompatible_qos: Accepted and never called: no two profiles are incompatible.
        liveliness: A publisher came or went.
        message_lost: Messages were published and did not come out of the queue.
        incompatible_type: A publisher has another type.
        matched: A publisher came or went.
        use_default_callbacks: Count handlers as rclpy does; type clashes are always logged.
    """

    def __init__(
        self,
        *,
        deadline: Callable[[QoSRequestedDeadlineMissedInfo], Any] | None = None,
        incompatible_qos: Callable[[QoSRequestedIncompatibleQoSInfo], Any] | None = None,
        liveliness: Callable[[QoSLivelinessChangedInfo], Any] | None = None,
        message_lost: Callable[[QoSMessageLostInfo], Any] | None = None,
        incompatible_type: Callable[[IncompatibleTypeInfo], Any] | None = None,
        matched: Callable[[QoSSubscriptionMatchedInfo], Any] | None = None,
        use_default_callbacks: bool = True,
    ) -> None:
        self.deadline = deadline
        self.incompatible_qos = incompatible_qos
        self.liveliness = liveliness
        self.message_lost = message_lost
        self.incompatible_type = incompatible_type
        self.matched = matched
        self.use_default_callbacks = use_default_callbacks

    def _by_kind(self) -> dict[EventKind, Callable[[Any], Any] | None]:
        return {
            _S.RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED: self.deadline,
            _S.RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS: self.incompatible_qos,
            _S.RCL_SUBSCRIPTION_LIVELINESS_CHANGED: self.liveliness,
            _S.RCL_SUBSCRIPTION_MESSAGE_LOST: self.message_lost,
            _S.RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE: self.incompatible_type,
            _S.RCL_SUBSCRIPTION_MATCHED: self.matched,
        }
