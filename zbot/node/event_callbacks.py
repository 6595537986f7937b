"""Callbacks for the QoS events of a publisher or a subscription, as in rclpy."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar

from zbot.executor.callback_check import always, check_callback
from zbot.node.event_handlers import LOGGED_BY_DEFAULT, InactiveHandler, ignore, make_handler
from zbot.node.qos_events import QoSPublisherEventType, QoSSubscriptionEventType

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.executor.ready_queue import ReadyQueue
    from zbot.graph.snapshot import Graph
    from zbot.node.qos_events import (
        EventKind,
        IncompatibleTypeInfo,
        QoSLivelinessChangedInfo,
        QoSLivelinessLostInfo,
        QoSMessageLostInfo,
        QoSOfferedDeadlineMissedInfo,
        QoSOfferedIncompatibleQoSInfo,
        QoSPublisherMatchedInfo,
        QoSRequestedDeadlineMissedInfo,
        QoSRequestedIncompatibleQoSInfo,
        QoSSubscriptionMatchedInfo,
    )

_P, _S = QoSPublisherEventType, QoSSubscriptionEventType


class _EventCallbacks:
    """Base class of the callbacks of publishers and subscriptions."""

    _kinds: ClassVar[dict[str, EventKind]]  #: the event of each callback
    use_default_callbacks: bool

    def _check(self) -> None:
        for argument in self._kinds:
            check_callback(
                f"{type(self).__name__}'s {argument}",
                getattr(self, argument),
                "(info)",
                argument=argument,
                position=None,
                may_be_none=always,
            )

    def attach(self, endpoint: Any, ready_queue: ReadyQueue, graph: Graph) -> None:
        """Create the endpoint's event handlers. The endpoint's `destroy()` ends the handlers."""
        for argument, kind in self._kinds.items():
            callback = getattr(self, argument)
            if callback is not None:
                handler = make_handler(kind, callback, endpoint, ready_queue, graph)
            elif self.use_default_callbacks and kind in LOGGED_BY_DEFAULT:
                # This handler logs nothing: zbot.node.diagnostics warns if a topic has two types.
                handler = InactiveHandler(ignore, endpoint.callback_group, ready_queue)
            else:
                continue
            endpoint.event_handlers.append(handler)


class PublisherEventCallbacks(_EventCallbacks):
    """Callbacks for the QoS events of a publisher. Each callback takes the event's info.

    Args:
        deadline: Called if nothing was published for a deadline period.
        liveliness: Called if the lease of a `MANUAL_BY_TOPIC` profile expired.
        incompatible_qos: Never called, because all profiles are compatible in zbot.
        incompatible_type: Called if a subscription has another type.
        matched: Called if a subscription of the topic was created or destroyed.
        use_default_callbacks: Whether `event_handlers` has handlers for default callbacks, as in
            rclpy. Different types of a topic are always logged.

    Raises:
        WrongTypeError: A callback is not callable.
        WrongStateError: A callback does not take one argument.
    """

    _kinds: ClassVar[dict[str, EventKind]] = {
        "deadline": _P.RCL_PUBLISHER_OFFERED_DEADLINE_MISSED,
        "liveliness": _P.RCL_PUBLISHER_LIVELINESS_LOST,
        "incompatible_qos": _P.RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS,
        "incompatible_type": _P.RCL_PUBLISHER_INCOMPATIBLE_TYPE,
        "matched": _P.RCL_PUBLISHER_MATCHED,
    }

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
        self._check()


class SubscriptionEventCallbacks(_EventCallbacks):
    """Callbacks for the QoS events of a subscription. Each callback takes the event's info.

    Args:
        deadline: Called if nothing was received for a deadline period.
        incompatible_qos: Never called, because all profiles are compatible in zbot.
        liveliness: Called if a publisher of the topic was created or destroyed.
        message_lost: Called if messages were published but not received.
        incompatible_type: Called if a publisher has another type.
        matched: Called if a publisher of the topic was created or destroyed.
        use_default_callbacks: Whether `event_handlers` has handlers for default callbacks, as in
            rclpy. Different types of a topic are always logged.

    Raises:
        WrongTypeError: A callback is not callable.
        WrongStateError: A callback does not take one argument.
    """

    _kinds: ClassVar[dict[str, EventKind]] = {
        "deadline": _S.RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED,
        "incompatible_qos": _S.RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS,
        "liveliness": _S.RCL_SUBSCRIPTION_LIVELINESS_CHANGED,
        "message_lost": _S.RCL_SUBSCRIPTION_MESSAGE_LOST,
        "incompatible_type": _S.RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE,
        "matched": _S.RCL_SUBSCRIPTION_MATCHED,
    }

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
        self._check()
