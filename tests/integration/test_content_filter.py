"""Tests of content filters and of the publisher in the message info."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from zbot.interfaces.content_filter import ContentFilterError
from zbot.node.message_decoder import ContentFilterOptions
from zbot.wire.serialization import deserialize_message

from std_msgs.msg import Int64

if TYPE_CHECKING:
    from tests.conftest import MakeContext, Spin

ABOVE_TWO = ContentFilterOptions("data > %0", ["2"])


@pytest.fixture
def node(make_context: MakeContext) -> zbot.Node:
    return zbot.Node("selective", context=make_context())


def publisher_of(node: zbot.Node) -> zbot.Publisher[Int64]:
    publisher = node.create_publisher(Int64, "number", 10)
    assert wait_until(lambda: publisher.get_subscription_count() == 1)
    return publisher


def numbered(publisher: zbot.Publisher[Int64], count: int) -> None:
    for number in range(count):
        publisher.publish(Int64(data=number))


@pytest.mark.parametrize("raw", [False, True])
def test_the_callback_receives_the_messages_that_match_the_filter(
    node: zbot.Node, spin: Spin, *, raw: bool
) -> None:
    inbox: list[Any] = []
    subscription = node.create_subscription(
        Int64, "number", inbox.append, 10, raw=raw, content_filter_options=ABOVE_TWO
    )
    assert subscription.is_cft_enabled
    numbered(publisher_of(node), 6)
    spin(node)
    assert wait_until(lambda: len(inbox) == 3)
    messages = [deserialize_message(data, Int64) if raw else data for data in inbox]
    assert [message.data for message in messages] == [3, 4, 5]


def test_an_invalid_filter_refuses_the_subscription(node: zbot.Node) -> None:
    bad = ContentFilterOptions("bogus > 3", [])
    with pytest.raises(ContentFilterError):
        node.create_subscription(Int64, "number", print, 10, content_filter_options=bad)
    assert not any(subscription.topic_name == "/number" for subscription in node.subscriptions)


def test_the_message_info_names_the_publisher(node: zbot.Node, spin: Spin) -> None:
    infos: list[Any] = []
    node.create_subscription(Int64, "number", lambda _, info: infos.append(info), 10)
    publisher = publisher_of(node)
    numbered(publisher, 1)
    spin(node)
    assert wait_until(lambda: bool(infos))
    assert infos[0]["publisher_gid"] == {
        "implementation_identifier": node.context.dialect.identifier,
        "data": publisher.token.gid,
    }
