"""Events of quality of service: matched, type clash, deadline, liveliness, message lost.

Zenoh enforces none of them, so they are found here: matches from the graph, losses from the numbers
that messages carry, deadlines and leases with a timer that looks whether anything was sent since.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot.clock import Clock
from zbot.qos import LivelinessPolicy
from zbot.time import ClockType
from zbot.timer import Timer
from zbot.wire.tokens import EndpointToken, EntityKind

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.callback_group import CallbackGroup
    from zbot.graph import Graph, Token
    from zbot.mailbox import Mailbox
    from zbot.time import Duration

_INFINITE_NS = 2**63 - 1


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
        mailbox: The node's way to its executor.
    """

    due_ns: int | None = None

    def __init__(
        self, callback: Callable[[Any], Any], callback_group: CallbackGroup, mailbox: Mailbox
    ) -> None:
        self.callback = callback
        self.callback_group = callback_group
        self.mailbox = mailbox
        self._infos: deque[Any] = deque()
        mailbox.add(self)

    def tell(self, info: Any) -> None:
        """Queue an event; from any thread."""
        self._infos.append(info)
        self.mailbox.post(self)

    def take(self) -> Any | None:
        """Return the oldest event, if any."""
        return self._infos.popleft() if self._infos else None

    def execute(self, info: Any) -> Any:
        """Call the callback."""
        return self.callback(info)

    def assert_liveliness(self) -> None:
        """Note that the publisher said it is alive."""

    def destroy(self) -> None:
        """Call the callback no more."""
        self.mailbox.remove(self)
        self._infos.clear()


class _PartnerHandler(EventHandler):
    """Follows the other side's endpoints on the topic."""

    def __init__(
        self,
        callback: Callable[[Any], Any],
        callback_group: CallbackGroup,
        mailbox: Mailbox,
        *,
        own: EndpointToken,
        graph: Graph,
    ) -> None:
        super().__init__(callback, callback_group, mailbox)
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
        mailbox: Mailbox,
        *,
        period: Duration,
        count: Callable[[], int],
        info: type[QoSCountInfo],
    ) -> None:
        super().__init__(callback, callback_group, mailbox)
        self._count = count
        self._info = info
        self._last = count()
        self._total = 0
        steady = Clock(clock_type=ClockType.STEADY_TIME)
        self._timer = Timer(self._look, callback_group, period.nanoseconds, steady, mailbox)
        mailbox.add(self._timer)

    def _look(self) -> None:
        count = self._count()
        if self._is_silent(count):
            self._total += 1
            self.tell(self._info(self._total, 1))
        self._last = count

    def _is_silent(self, count: int) -> bool:
        return count == self._last

    def destroy(self) -> None:
        self._timer.destroy()
        self.mailbox.remove(self._timer)
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


class PublisherEventCallbacks:
    """What a publisher wants to hear; each callback takes the event's info.

    Args:
        deadline: Nothing was published for a deadline period.
        liveliness: The lease of a `MANUAL_BY_TOPIC` profile ran out.
        incompatible_qos: Accepted and never called: no two profiles are incompatible.
        incompatible_type: A subscription has another type.
        matched: A subscription came or went.
        use_default_callbacks: Accepted; type clashes are always logged.
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

    def attach(self, publisher: Any, mailbox: Mailbox, graph: Graph) -> None:
        """Make the handlers of a publisher; its `destroy()` ends them."""
        group, own, handlers = publisher.callback_group, publisher.token, publisher.event_handlers
        if self.matched is not None:
            handlers.append(_PartnerHandler(self.matched, group, mailbox, own=own, graph=graph))
        if self.incompatible_type is not None:
            handlers.append(
                _TypeClashHandler(self.incompatible_type, group, mailbox, own=own, graph=graph)
            )
        if self.deadline is not None and _is_finite(own.qos.deadline):
            handlers.append(
                _SilenceHandler(
                    self.deadline,
                    group,
                    mailbox,
                    period=own.qos.deadline,
                    count=lambda: publisher.sent_count,
                    info=QoSOfferedDeadlineMissedInfo,
                )
            )
        lease = own.qos.liveliness_lease_duration
        is_manual = own.qos.liveliness is LivelinessPolicy.MANUAL_BY_TOPIC
        if self.liveliness is not None and is_manual and _is_finite(lease):
            handlers.append(
                _LeaseHandler(
                    self.liveliness,
                    group,
                    mailbox,
                    period=lease,
                    count=lambda: publisher.sent_count,
                    info=QoSLivelinessLostInfo,
                )
            )


class SubscriptionEventCallbacks:
    """What a subscription wants to hear; each callback takes the event's info.

    Args:
        deadline: Nothing came for a deadline period.
        incompatible_qos: Accepted and never called: no two profiles are incompatible.
        liveliness: A publisher came or went.
        message_lost: Messages were published and did not come out of the queue.
        incompatible_type: A publisher has another type.
        matched: A publisher came or went.
        use_default_callbacks: Accepted; type clashes are always logged.
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

    def attach(self, subscription: Any, mailbox: Mailbox, graph: Graph) -> None:
        """Make the handlers of a subscription; its `destroy()` ends them."""
        group, own = subscription.callback_group, subscription.token
        handlers = subscription.event_handlers
        for callback, kind in (
            (self.matched, _PartnerHandler),
            (self.liveliness, _LivelinessChangedHandler),
            (self.incompatible_type, _TypeClashHandler),
        ):
            if callback is not None:
                handlers.append(kind(callback, group, mailbox, own=own, graph=graph))
        if self.message_lost is not None:
            loss = _LossHandler(self.message_lost, group, mailbox)
            subscription.report_losses_to(loss.add)
            handlers.append(loss)
        if self.deadline is not None and _is_finite(own.qos.deadline):
            handlers.append(
                _SilenceHandler(
                    self.deadline,
                    group,
                    mailbox,
                    period=own.qos.deadline,
                    count=lambda: subscription.received_count,
                    info=QoSRequestedDeadlineMissedInfo,
                )
            )
