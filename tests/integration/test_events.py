"""Tests of quality-of-service events of publishers and subscriptions."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

import zbot
from tests.conftest import wait_until
from zbot.executor.wait_set import WaitSet
from zbot.node.event_callbacks import PublisherEventCallbacks, SubscriptionEventCallbacks
from zbot.node.event_handlers import EventHandle
from zbot.node.qos_events import (
    IncompatibleTypeInfo,
    QoSLivelinessChangedInfo,
    QoSLivelinessLostInfo,
    QoSMatchedInfo,
    QoSMessageLostInfo,
    QoSOfferedDeadlineMissedInfo,
    QoSOfferedIncompatibleQoSInfo,
    QoSPublisherEventType,
    QoSRequestedDeadlineMissedInfo,
    QoSSubscriptionEventType,
)
from zbot.qos import HistoryPolicy, LivelinessPolicy, QoSPolicyKind, QoSProfile

from std_msgs.msg import Float32, Int64, String

if TYPE_CHECKING:
    from tests.conftest import Spin
    from zbot.log.record import Record

KEEP_ALL = QoSProfile(history=HistoryPolicy.KEEP_ALL)


def offer(node: zbot.Node, kind: type[Any], qos: Any = 10, **callbacks: Any) -> Any:
    """Create a publisher of "chatter" with callbacks for its events."""
    events = PublisherEventCallbacks(**callbacks)
    return node.create_publisher(kind, "chatter", qos, event_callbacks=events)


def request(
    node: zbot.Node, kind: type[Any], qos: Any = 10, take: Any = print, **callbacks: Any
) -> Any:
    """Create a subscription to "chatter" with callbacks for its events."""
    events = SubscriptionEventCallbacks(**callbacks)
    return node.create_subscription(kind, "chatter", take, qos, event_callbacks=events)


def every(seconds: float) -> QoSProfile:
    return QoSProfile(depth=10, deadline=zbot.Duration(seconds=seconds))


def leased(seconds: float, liveliness: LivelinessPolicy) -> QoSProfile:
    lease = zbot.Duration(seconds=seconds)
    return QoSProfile(depth=10, liveliness=liveliness, liveliness_lease_duration=lease)


def test_a_publisher_is_notified_of_subscriptions_that_come_and_go(
    talker: zbot.Node, listener: zbot.Node, spin: Spin
) -> None:
    infos: list[QoSMatchedInfo] = []
    listener.create_subscription(String, "chatter", print, 10)
    offer(talker, String, matched=infos.append)
    spin(talker)
    assert wait_until(lambda: infos == [QoSMatchedInfo(1, 1, 1, 1)])
    second = listener.create_subscription(String, "chatter", print, 10)
    assert wait_until(lambda: infos[1:] == [QoSMatchedInfo(2, 1, 2, 1)])
    listener.destroy_subscription(second)
    assert wait_until(lambda: infos[2:] == [QoSMatchedInfo(2, 0, 1, -1)])
    listener.context.shutdown()
    assert wait_until(lambda: infos[3:] == [QoSMatchedInfo(2, 0, 0, -1)])


def test_every_endpoint_has_the_handlers_of_rclpy(talker: zbot.Node) -> None:
    def handlers(**callbacks: Any) -> int:
        events = PublisherEventCallbacks(**callbacks)
        return len(talker.create_publisher(String, "a", 1, event_callbacks=events).event_handlers)

    assert len(talker.create_publisher(String, "a", 1).event_handlers) == 2
    assert handlers(use_default_callbacks=False) == 0
    assert handlers(incompatible_qos=print, incompatible_type=print) == 2
    assert handlers(deadline=print, liveliness=print, matched=print) == 5


def test_an_event_can_be_waited_for_and_taken_without_an_executor(
    talker: zbot.Node, listener: zbot.Node
) -> None:
    publisher = talker.create_publisher(String, "chatter", every(0.05))
    matched = EventHandle(publisher.handle, QoSPublisherEventType.RCL_PUBLISHER_MATCHED)
    missed = EventHandle(
        publisher.handle, QoSPublisherEventType.RCL_PUBLISHER_OFFERED_DEADLINE_MISSED
    )
    never = EventHandle(
        publisher.handle, QoSPublisherEventType.RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS
    )
    assert never.take_event() == QoSOfferedIncompatibleQoSInfo(0, 0, QoSPolicyKind.INVALID)
    listener.create_subscription(String, "chatter", print, 10)
    found = {matched: QoSMatchedInfo(1, 1, 1, 1), missed: QoSOfferedDeadlineMissedInfo(1, 1)}
    for handle, info in found.items():
        events = WaitSet()
        index, silent = events.add_event(handle), events.add_event(never)
        events.wait(10 * 10**9)
        assert (events.is_ready("event", index), events.is_ready("event", silent)) == (True, False)
        assert handle.take_event() == info
        handle.destroy_when_not_in_use()


def test_a_lost_message_reaches_the_callback_and_a_handle(listener: zbot.Node) -> None:
    infos: list[QoSMessageLostInfo] = []
    events = SubscriptionEventCallbacks(message_lost=infos.append)
    subscription = listener.create_subscription(Int64, "n", print, 1, event_callbacks=events)
    handle = EventHandle(
        subscription.handle, QoSSubscriptionEventType.RCL_SUBSCRIPTION_MESSAGE_LOST
    )
    publisher = listener.create_publisher(Int64, "n", 10)
    executor = zbot.SingleThreadedExecutor(context=listener.context)
    executor.add_node(listener)
    for numbers in ((1,), (2, 3, 4)):
        for number in numbers:
            publisher.publish(Int64(data=number))
        while subscription.received_count < len(numbers) // 3 + 1:
            executor.spin_once(timeout_sec=2)
    while not infos:
        executor.spin_once(timeout_sec=2)
    assert infos == [handle.take_event()] == [QoSMessageLostInfo(2, 2)]


def test_a_subscription_is_notified_of_publishers_that_come_and_go(
    talker: zbot.Node, listener: zbot.Node, spin: Spin
) -> None:
    infos: list[QoSMatchedInfo] = []
    request(listener, String, matched=infos.append)
    spin(listener)
    talker.create_publisher(String, "elsewhere", 10)
    publisher = talker.create_publisher(String, "chatter", 10)
    assert wait_until(lambda: infos == [QoSMatchedInfo(1, 1, 1, 1)])
    publisher.destroy()
    assert wait_until(lambda: infos[1:] == [QoSMatchedInfo(1, 0, 0, -1)])


def test_a_subscription_is_notified_of_the_number_of_live_publishers(
    talker: zbot.Node, listener: zbot.Node, spin: Spin
) -> None:
    infos: list[QoSLivelinessChangedInfo] = []
    request(listener, String, liveliness=infos.append)
    spin(listener)
    talker.create_publisher(String, "chatter", 10)
    assert wait_until(lambda: infos == [QoSLivelinessChangedInfo(1, 0, 1, 0)])
    talker.context.shutdown()
    assert wait_until(lambda: infos[1:] == [QoSLivelinessChangedInfo(0, 1, -1, 1)])


def test_both_endpoints_are_notified_of_an_inconsistent_type(
    talker: zbot.Node, listener: zbot.Node, spin: Spin
) -> None:
    at_talker: list[IncompatibleTypeInfo] = []
    at_listener: list[IncompatibleTypeInfo] = []
    matched: list[Any] = []
    offer(talker, Float32, incompatible_type=at_talker.append, matched=matched.append)
    request(listener, String, incompatible_type=at_listener.append, matched=matched.append)
    spin(talker)
    spin(listener)
    assert wait_until(lambda: at_talker == at_listener == [IncompatibleTypeInfo(1, 1)])
    assert matched == []


def test_a_subscription_is_notified_of_the_number_of_lost_messages(
    talker: zbot.Node, listener: zbot.Node, logged: list[Record]
) -> None:
    infos: list[QoSMessageLostInfo] = []
    inbox: list[int] = []
    request(
        listener,
        Int64,
        2,
        take=lambda message: inbox.append(message.data),
        message_lost=infos.append,
    )
    mark = listener.create_subscription(String, "mark", lambda _: None, 1)
    publisher = talker.create_publisher(Int64, "chatter", KEEP_ALL)
    marker = talker.create_publisher(String, "mark", KEEP_ALL)
    executor = zbot.SingleThreadedExecutor(context=listener.context)
    executor.add_node(listener)
    publisher.publish(Int64(data=0))
    while not inbox:
        executor.spin_once(timeout_sec=2)
    for number in range(1, 11):
        publisher.publish(Int64(data=number))
    marker.publish(String())
    assert wait_until(lambda: mark.has_work)
    while not infos:
        executor.spin_once(timeout_sec=2)
    assert infos == [QoSMessageLostInfo(8, 8)]
    assert inbox[:2] == [0, 9]
    assert not [record for record in logged if "lost" in record.message]


def test_each_missed_deadline_is_an_event(talker: zbot.Node, spin: Spin) -> None:
    offered: list[QoSOfferedDeadlineMissedInfo] = []
    requested: list[QoSRequestedDeadlineMissedInfo] = []
    offer(talker, String, every(0.01), deadline=offered.append)
    request(talker, String, every(0.01), deadline=requested.append)
    spin(talker)
    assert wait_until(lambda: len(offered) >= 3 and len(requested) >= 3)
    assert offered[:3] == [QoSOfferedDeadlineMissedInfo(count, 1) for count in (1, 2, 3)]
    assert requested[:3] == [QoSRequestedDeadlineMissedInfo(count, 1) for count in (1, 2, 3)]


def test_a_kept_deadline_is_not_an_event(talker: zbot.Node, spin: Spin) -> None:
    missed: list[Any] = []
    publisher = offer(talker, Int64, every(1), deadline=missed.append)
    inbox: list[Int64] = []
    request(talker, Int64, every(1), take=inbox.append, deadline=missed.append)
    talker.create_timer(0.01, lambda: publisher.publish(Int64()))
    begin = time.monotonic()
    spin(talker)
    assert wait_until(lambda: time.monotonic() - begin > 1.5 and bool(inbox))
    assert missed == []


def test_asserting_liveliness_does_not_keep_a_deadline(talker: zbot.Node, spin: Spin) -> None:
    missed: list[Any] = []
    publisher = offer(talker, String, every(0.01), deadline=missed.append)
    talker.create_timer(0.001, publisher.assert_liveliness)
    spin(talker)
    assert wait_until(lambda: bool(missed))


def test_an_expired_lease_is_one_event_until_it_is_renewed(talker: zbot.Node, spin: Spin) -> None:
    lost: list[QoSLivelinessLostInfo] = []
    ticks: list[int] = []
    publisher = offer(
        talker, String, leased(0.02, LivelinessPolicy.MANUAL_BY_TOPIC), liveliness=lost.append
    )
    talker.create_timer(0.02, lambda: ticks.append(1))
    spin(talker)
    assert wait_until(lambda: len(ticks) > 5)
    assert lost == [QoSLivelinessLostInfo(1, 1)]
    publisher.assert_liveliness()
    assert wait_until(lambda: len(lost) == 2)
    publisher.publish(String())
    assert wait_until(lambda: len(lost) == 3)
    assert lost[2] == QoSLivelinessLostInfo(3, 1)


def test_an_automatic_lease_lasts_as_long_as_the_process(talker: zbot.Node, spin: Spin) -> None:
    lost: list[Any] = []
    ticks: list[int] = []
    offer(talker, String, leased(0.01, LivelinessPolicy.AUTOMATIC), liveliness=lost.append)
    talker.create_timer(0.01, lambda: ticks.append(1))
    spin(talker)
    assert wait_until(lambda: len(ticks) > 5)
    assert lost == []


def test_a_destroyed_endpoint_has_no_events(
    talker: zbot.Node, listener: zbot.Node, spin: Spin
) -> None:
    infos: list[Any] = []
    ticks: list[int] = []
    publisher = offer(talker, String, every(0.01), matched=infos.append, deadline=infos.append)
    talker.create_timer(0.01, lambda: ticks.append(1))
    spin(talker)
    assert wait_until(lambda: bool(infos))
    talker.destroy_publisher(publisher)
    ticks.clear()
    assert wait_until(lambda: bool(ticks))  # a callback that ran during the destruction has ended
    infos.clear()
    listener.create_subscription(String, "chatter", print, 10)
    assert wait_until(lambda: talker.count_subscribers("chatter") == 1)
    ticks.clear()
    assert wait_until(lambda: len(ticks) > 3)
    assert infos == []


def test_handlers_of_events_that_never_occur_are_accepted(talker: zbot.Node) -> None:
    talker.create_publisher(
        String, "a", 10, event_callbacks=PublisherEventCallbacks(incompatible_qos=print)
    )
    talker.create_subscription(
        String, "a", print, 10, event_callbacks=SubscriptionEventCallbacks(incompatible_qos=print)
    )
