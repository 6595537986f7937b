"""Functions that replace rclpy's C classes. With them, programs build their own `Waitable`.

Each function creates an object of zbot, and returns its handle. No executor runs the callbacks of
this object. Instead, the program adds the handle to its wait set, and gets messages or requests
from the handle. A subscription, service or client is destroyed together with its node.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.executor import guard_condition, timer
from zbot.executor.callback_group import ReentrantCallbackGroup
from zbot.executor.ready_queue import ReadyQueue
from zbot.node import client, service, subscription
from zbot.qos import PlainQoSProfile, QoSProfile
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from zbot.context import Context
    from zbot.executor.clock import Clock
    from zbot.node.state import NodeState
    from zbot.threads.handle import Handle


class _Own:
    """Options of an object that uses its own ready queue, and not the node's queue."""

    def __init__(self, node: NodeState) -> None:
        self.options: dict[str, Any] = {
            "ready_queue": ReadyQueue(),
            "callback_group": ReentrantCallbackGroup(),
            "logger_name": node.logger_name,
        }


def _profile(qos: PlainQoSProfile) -> QoSProfile:
    return QoSProfile(**qos.to_dict())


def Subscription(  # noqa: N802 - rclpy's name of a class
    node: NodeState, msg_type: type[Any], topic: str, qos: PlainQoSProfile
) -> subscription.SubscriptionHandle:
    """Return the handle of a subscription."""
    name = node.resolve(topic, is_service=False)
    token = node.endpoint(EntityKind.SUBSCRIPTION, name, msg_type, _profile(qos))
    made: subscription.Subscription[Any] = subscription.Subscription(
        node.context, msg_type, lambda _: None, token, raw=False, **_Own(node).options
    )
    node.subscriptions.append(made)
    made.start()
    return made.handle


def Service(  # noqa: N802 - rclpy's name of a class
    node: NodeState, srv_type: type[Any], service_name: str, qos: PlainQoSProfile
) -> service.ServiceHandle:
    """Return the handle of a service."""
    name = node.resolve(service_name, is_service=True)
    token = node.endpoint(EntityKind.SERVICE, name, srv_type, _profile(qos))
    made: service.Service[Any, Any] = service.Service(
        node.context, srv_type, lambda _, response: response, token, **_Own(node).options
    )
    node.services.append(made)
    return made.handle


def Client(  # noqa: N802 - rclpy's name of a class
    node: NodeState, srv_type: type[Any], service_name: str, qos: PlainQoSProfile
) -> client.ClientHandle:
    """Return the handle of a client."""
    name = node.resolve(service_name, is_service=True)
    token = node.endpoint(EntityKind.CLIENT, name, srv_type, _profile(qos))
    made: client.Client[Any, Any] = client.Client(
        node.context, srv_type, token, **_Own(node).options
    )
    node.clients.append(made)
    return made.handle


def GuardCondition(  # noqa: N802 - rclpy's name of a class
    context: Handle[Context],
) -> guard_condition.GuardConditionHandle:
    """Return the handle of a guard condition. With it, any thread can make the waitable ready."""
    return guard_condition.GuardCondition(context=context.entity).handle


def Timer(  # noqa: N802 - rclpy's name of a class
    clock: Clock,
    context: Handle[Context],  # noqa: ARG001 - rclpy's signature
    period_nsec: int,
    autostart: bool = True,
) -> timer.TimerHandle:
    """Return the handle of a timer. The timer makes the waitable ready after each period."""
    group = ReentrantCallbackGroup()
    return timer.Timer(None, group, period_nsec, clock, ReadyQueue(), autostart=autostart).handle
