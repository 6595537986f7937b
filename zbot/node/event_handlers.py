"""Handlers that detect QoS events and run their callbacks.

Zenoh reports none of these events. The graph shows matched endpoints and endpoints with another
type. The sequence numbers in the messages show lost messages. A timer finds missed deadlines and
expired leases: it checks whether a message was sent or received since the last check.
"""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING, Any

from zbot.executor.clock import Clock
from zbot.executor.ready_queue import ReadyQueue
from zbot.executor.timer import Timer
from zbot.node.qos_events import (
    EventKind,
    IncompatibleTypeInfo,
    QoSCountInfo,
    QoSLivelinessChangedInfo,
    QoSLivelinessLostInfo,
    QoSMatchedInfo,
    QoSMessageLostInfo,
    QoSOfferedDeadlineMissedInfo,
    QoSOfferedIncompatibleQoSInfo,
    QoSPublisherEventType,
    QoSRequestedDeadlineMissedInfo,
    QoSRequestedIncompatibleQoSInfo,
    QoSSubscriptionEventType,
)
from zbot.qos import LivelinessPolicy, QoSPolicyKind
from zbot.threads.handle import Handle
from zbot.time import ClockType
from zbot.wire.tokens import EndpointToken, EntityKind

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.executor.callback_group import CallbackGroup
    from zbot.graph.snapshot import Graph, Token
    from zbot.time import Duration

_INFINITE_NS = 2**63 - 1
_P, _S = QoSPublisherEventType, QoSSubscriptionEventType


class EventHandler:
    """Runs the callback of one kind of event in the node's executor.

    Args:
        callback: Takes the event's info.
        callback_group: Decides which other callbacks may run at the same time.
        ready_queue: The queue that the node's executor takes ready entities from.
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
        """Time of the next check by a timer, if any (monotonic clock, nanoseconds)."""
        return None

    def add_event(self, info: Any) -> None:
        """Queue an event. Any thread may call this."""
        self._infos.append(info)
        self.ready_queue.post(self)

    def take(self) -> Any | None:
        """Return the oldest event, if any."""
        return self._infos.popleft() if self._infos else None

    @property
    def has_work(self) -> bool:
        """Whether there is an event to take."""
        return bool(self._infos)

    def execute(self, info: Any) -> Any:
        """Call the callback."""
        return self.callback(info)

    def assert_liveliness(self) -> None:
        """Note that the program called `assert_liveliness`. Most handlers do not need this."""

    def destroy(self) -> None:
        """Remove the handler and its events."""
        self.ready_queue.remove(self)
        self._infos.clear()


class InactiveHandler(EventHandler):
    """Handler of an event that never happens, such as incompatible profiles in zbot."""

    def __init__(
        self, callback: Callable[[Any], Any], callback_group: CallbackGroup, ready_queue: ReadyQueue
    ) -> None:
        self.callback, self.callback_group, self.ready_queue = callback, callback_group, ready_queue
        self._infos = deque()  # the executor does not know this handler


class _EndpointHandler(EventHandler):
    """Reports matching endpoints: subscriptions of a publisher, or publishers of a subscription."""

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
        self._other_kind = EntityKind.SUBSCRIPTION if published else EntityKind.PUBLISHER
        self._own = own
        self._graph = graph
        self._known: set[str] = set()
        self._total = 0
        graph.follow(own)
        graph.add_listener(self._on_change)

    def _concerns(self, token: EndpointToken) -> bool:
        return token.type_name == self._own.type_name

    def _on_change(self, token: Token, appeared: bool) -> None:
        if not isinstance(token, EndpointToken) or token.kind is not self._other_kind:
            return
        if token.name != self._own.name or not self._concerns(token):
            return
        if appeared == (token.key in self._known):
            return
        (self._known.add if appeared else self._known.discard)(token.key)
        self._total += appeared
        self._report(appeared=appeared)

    def _report(self, *, appeared: bool) -> None:
        self.add_event(
            QoSMatchedInfo(self._total, int(appeared), len(self._known), 1 if appeared else -1)
        )

    def destroy(self) -> None:
        self._graph.remove_listener(self._on_change)
        super().destroy()


class _LivelinessChangedHandler(_EndpointHandler):
    def _report(self, *, appeared: bool) -> None:
        change = 1 if appeared else -1
        gone = self._total - len(self._known)
        self.add_event(
            QoSLivelinessChangedInfo(len(self._known), gone, change, 0 if appeared else 1)
        )


class _IncompatibleTypeHandler(_EndpointHandler):
    def _concerns(self, token: EndpointToken) -> bool:
        return token.type_name != self._own.type_name

    def _report(self, *, appeared: bool) -> None:
        if appeared:
            self.add_event(IncompatibleTypeInfo(self._total, 1))


class _MessageLostHandler(EventHandler):
    _total = 0

    def add(self, missing: int) -> None:
        self._total += missing
        self.add_event(QoSMessageLostInfo(self._total, missing))


class _DeadlineHandler(EventHandler):
    """Reports each whole period in which the number of messages did not change."""

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
        # This call is the last, because the executor may use the handler immediately.
        super().__init__(callback, callback_group, ready_queue)

    @property
    def due_ns(self) -> int | None:
        return self._timer.due_ns

    @property
    def has_work(self) -> bool:
        self._check_timer()
        return super().has_work

    def take(self) -> Any | None:
        self._check_timer()
        return super().take()

    def _check_timer(self) -> None:
        if self._timer.take() is None:
            return
        count = self._count()
        if self._is_missed(count):
            self._total += 1
            self.add_event(self._info(self._total, 1))
        self._last = count

    def _is_missed(self, count: int) -> bool:
        return count == self._last

    def destroy(self) -> None:
        self._timer.destroy()
        super().destroy()


class _LeaseHandler(_DeadlineHandler):
    """Reports that a publisher's lease expired without a message and without `assert_liveliness`.

    If the following leases expire too, they are not reported.
    """

    _was_asserted = False
    _is_lost = False

    def assert_liveliness(self) -> None:
        self._was_asserted = True

    def _is_missed(self, count: int) -> bool:
        was_lost = self._is_lost
        self._is_lost = super()._is_missed(count) and not self._was_asserted
        self._was_asserted = False
        return self._is_lost and not was_lost


def _is_finite(period: Duration) -> bool:
    return 0 < period.nanoseconds < _INFINITE_NS


def make_handler(
    kind: EventKind,
    callback: Callable[[Any], Any],
    endpoint: Any,
    ready_queue: ReadyQueue,
    graph: Graph,
) -> EventHandler:
    """Return the handler for one kind of event of a publisher or subscription."""
    group, own = endpoint.callback_group, endpoint.token
    if kind in _ENDPOINT_HANDLERS:
        return _ENDPOINT_HANDLERS[kind](callback, group, ready_queue, own=own, graph=graph)
    if kind is _S.RCL_SUBSCRIPTION_MESSAGE_LOST:
        lost = _MessageLostHandler(callback, group, ready_queue)
        endpoint.report_losses_to(lost.add)
        return lost
    period, handler = own.qos.deadline, _DeadlineHandler
    if kind is _P.RCL_PUBLISHER_LIVELINESS_LOST:
        period, handler = own.qos.liveliness_lease_duration, _LeaseHandler
        if own.qos.liveliness is not LivelinessPolicy.MANUAL_BY_TOPIC:
            return InactiveHandler(callback, group, ready_queue)
    if kind in _INCOMPATIBLE_QOS or not _is_finite(period):
        return InactiveHandler(callback, group, ready_queue)

    def count() -> int:
        messages: int = endpoint.sent_count if kind in _P else endpoint.received_count
        return messages

    info = type(_NO_EVENT[kind])
    return handler(callback, group, ready_queue, period=period, count=count, info=info)


_ENDPOINT_HANDLERS: dict[EventKind, type[_EndpointHandler]] = {
    _P.RCL_PUBLISHER_INCOMPATIBLE_TYPE: _IncompatibleTypeHandler,
    _P.RCL_PUBLISHER_MATCHED: _EndpointHandler,
    _S.RCL_SUBSCRIPTION_LIVELINESS_CHANGED: _LivelinessChangedHandler,
    _S.RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE: _IncompatibleTypeHandler,
    _S.RCL_SUBSCRIPTION_MATCHED: _EndpointHandler,
}
_INCOMPATIBLE_QOS: tuple[EventKind, ...] = (
    _P.RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS,
    _S.RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS,
)
# Events that a default callback logs in ROS 2.
LOGGED_BY_DEFAULT: tuple[EventKind, ...] = (
    *_INCOMPATIBLE_QOS,
    _P.RCL_PUBLISHER_INCOMPATIBLE_TYPE,
    _S.RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE,
)
#: The info of each kind before the first event.
_NO_EVENT: dict[EventKind, Any] = {
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


def ignore(info: object) -> None:
    """Do nothing: the program takes the event itself, or `zbot.node.diagnostics` logs it."""


class EventHandle(Handle[EventHandler]):
    """Handle of one kind of event for a `WaitSet`. A program can also take events from the handle.

    Args:
        parent: The publisher's or subscription's handle.
        kind: The kind of event.
    """

    def __init__(self, parent: Handle[Any], kind: EventKind) -> None:
        endpoint = parent.entity
        graph = endpoint.context.graph
        super().__init__(make_handler(kind, ignore, endpoint, ReadyQueue(), graph))
        self._no_event = _NO_EVENT[kind]

    def take_event(self) -> Any:
        """Return the info of the oldest event. If there is no event, the info has counts of 0."""
        info = self.entity.take()
        return self._no_event if info is None else info
