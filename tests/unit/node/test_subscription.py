"""Tests of what a subscription does with a sample, without an open session."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

import msgpack  # type: ignore[import-untyped]
import pytest
import zenoh

from tests.unit.node.fakes import GID, TOPIC, Sample, sample, subscription
from zbot.errors import WrongStateError
from zbot.interfaces.content_filter import ContentFilterError
from zbot.node.message_decoder import ContentFilterOptions
from zbot.node.subscription import Subscription
from zbot.qos import HistoryPolicy, QoSProfile
from zbot.wire.serialization import deserialize_message

from std_msgs.msg import Int64, String

if TYPE_CHECKING:
    from zbot.log.record import Record

FLOAT32 = "application/msgpack;std_msgs/msg/Float32"
INT8 = "application/msgpack;std_msgs/msg/Int8"
ABOVE_TWO = ContentFilterOptions("data > %0", ["2"])


def packed(value: object) -> bytes:
    data: bytes = msgpack.Packer().pack(value)
    return data


def nested(depth: int) -> bytes:
    return b"\x81\xa4data" * depth + b"\xc0"


def received(subscription: Subscription[Any], *samples: Any) -> None:
    for sample_given in samples:
        assert subscription.execute(sample_given) is None


# -- messages --------------------------------------------------------------------------------------


def test_the_callback_gets_the_message() -> None:
    inbox = list[String]()
    received(subscription(inbox.append), sample(String(data="grüße"), 1))
    assert inbox == [String(data="grüße")]


def test_a_callback_with_two_arguments_gets_times_numbers_and_the_publisher() -> None:
    infos = list[Any]()
    listener = subscription(lambda _, info: infos.append(info))
    before = time.time_ns()
    received(listener, sample(String(), 7, stamp_ns=5), sample(String(), 8))
    assert [info["publication_sequence_number"] for info in infos] == [7, 8]
    assert [info["reception_sequence_number"] for info in infos] == [1, 2]
    assert infos[0]["source_timestamp"] == 5
    assert infos[0]["received_timestamp"] >= before
    expected = {"implementation_identifier": "rmw_zbot_zenoh", "data": GID}
    assert infos[0]["publisher_gid"] == expected


def test_a_plain_put_without_attachment_is_accepted() -> None:
    inbox = list[Any]()
    listener = subscription(lambda message, info: inbox.append((message, info)))
    received(listener, sample(packed({"data": "plain"})))
    message, info = inbox[0]
    assert message.data == "plain"
    assert (info["source_timestamp"], info["publication_sequence_number"]) == (0, 0)
    assert info["publisher_gid"] is None


@pytest.mark.parametrize("attachment", [b"", b"short", b"x" * 32, b"x" * 1000])
def test_a_foreign_attachment_is_not_an_error(attachment: bytes) -> None:
    inbox = list[String]()
    foreign = Sample(zenoh.ZBytes(packed({"data": "x"})), zenoh.ZBytes(attachment))
    received(subscription(inbox.append), foreign)
    assert inbox == [String(data="x")]


def test_a_coroutine_function_returns_its_coroutine_to_the_executor() -> None:
    async def listen(_: String) -> None:
        pass

    coroutine = subscription(listen).execute(sample(String(), 1))
    assert hasattr(coroutine, "send")
    coroutine.close()


def test_a_subscription_knows_the_arguments_of_its_callback() -> None:
    kinds = Subscription.CallbackType
    assert subscription(lambda _: None)._callback_type is kinds.MessageOnly
    assert subscription(lambda _, __: None)._callback_type is kinds.WithMessageInfo


def test_a_missing_number_counts_as_a_lost_message() -> None:
    listener = subscription(lambda _: None)
    received(listener, *(sample(String(), number) for number in (1, 2, 5)))
    assert (listener.lost_count, listener.received_count) == (2, 3)


def test_the_depth_limits_the_samples_that_wait() -> None:
    numbers = list[int]()
    listener = subscription(
        lambda message: numbers.append(message.data), msg_type=Int64, qos=QoSProfile(depth=5)
    )
    channel: Any = listener.context
    channel.channel.samples.extend(sample(Int64(data=n), n) for n in range(1, 101))
    assert listener.has_work
    while (taken := listener.take()) is not None:
        received(listener, taken)
    assert numbers == [96, 97, 98, 99, 100]


def test_a_destroyed_subscription_leaves_the_graph_and_calls_no_callback() -> None:
    inbox = list[String]()
    listener = subscription(inbox.append)
    context: Any = listener.context
    assert len(context.declared) == 2
    for _ in range(2):
        listener.destroy()
    assert context.declared == [f"0{TOPIC}"]
    assert listener.is_destroyed
    received(listener, sample(String(), 1))
    assert inbox == []


# -- messages that cannot be read ------------------------------------------------------------------


@pytest.mark.parametrize(
    ("payload", "encoding"),
    [
        (b"\xc1\xc1\xc1", ""),
        (b"", ""),
        (b"plain text", "text/plain"),
        (packed([1, 2, 3]), ""),
        (packed({"data": 5}), ""),
        (packed({"data": b"\xff"}), ""),
        (nested(100_000), ""),
        (b"\xdd\xff\xff\xff\xff", ""),
        (packed({"data": "x"})[:-1], "application/msgpack;std_msgs/msg/String"),
    ],
    ids=["no msgpack", "empty", "text", "array", "int", "bin", "deep", "4 billion", "cut"],
)
def test_invalid_bytes_are_one_log_line_and_the_next_message_arrives(
    logged: list[Record], payload: bytes, encoding: str
) -> None:
    inbox = list[String]()
    listener = subscription(inbox.append)
    wrong = sample(payload, encoding=encoding)
    received(listener, wrong, wrong, sample(String(data="good"), 1))
    assert inbox == [String(data="good")]
    assert listener.refused_count == 2
    assert len(logged) == 1
    assert logged[0].message.startswith("/chatter: cannot read a message")


def test_each_kind_of_refusal_is_logged_once(logged: list[Record]) -> None:
    listener = subscription()
    for _ in range(2):
        received(listener, *(sample(packed({}), encoding=kind) for kind in (FLOAT32, INT8)))
    assert listener.refused_count == 4
    assert [record.message.split(": ")[2].split(",")[0] for record in logged] == [
        "it is std_msgs/msg/Float32",
        "it is std_msgs/msg/Int8",
    ]


def test_only_three_reasons_are_logged(logged: list[Record]) -> None:
    kinds = [f"application/msgpack;std_msgs/msg/Int{bits}" for bits in (8, 16, 32, 64)]
    received(subscription(), *(sample(packed({}), encoding=kind) for kind in kinds))
    assert len(logged) == 3


def test_two_types_on_one_topic_do_not_mix() -> None:
    inbox = list[String]()
    listener = subscription(inbox.append)
    wrong = [sample(packed({"data": 1.0}), n, gid=bytes(16), encoding=FLOAT32) for n in (1, 2, 3)]
    received(listener, *wrong, sample(String(data="good"), 1))
    assert inbox == [String(data="good")]
    assert (listener.received_count, listener.refused_count) == (1, 3)


@pytest.mark.parametrize("raw", [False, True])
def test_a_text_that_is_not_utf8_arrives_with_one_warning(
    logged: list[Record], *, raw: bool
) -> None:
    inbox = list[Any]()
    listener = subscription(inbox.append, raw=raw)
    text = sample(b"\x81\xa4data\xa4caf\xe9")
    received(listener, text, text)
    assert len(inbox) == 2
    if not raw:
        assert inbox == [String(data="caf\ufffd")] * 2
    assert listener.refused_count == 0
    assert len(logged) == (not raw)


def test_a_subscription_of_bytes_gets_what_was_sent_with_its_type() -> None:
    inbox = list[bytes]()
    listener = subscription(inbox.append, raw="payload")
    received(listener, sample(b"\xc1 not MessagePack", 1))
    assert inbox == [b"\xc1 not MessagePack"]
    other = subscription(inbox.append, raw="payload")
    received(other, sample(b"\xc1 not MessagePack", 1, encoding=FLOAT32))
    assert len(inbox) == other.refused_count == 1


# -- content filter --------------------------------------------------------------------------------


def numbers(*values: int) -> list[Any]:
    return [sample(Int64(data=value), number) for number, value in enumerate(values, 1)]


@pytest.mark.parametrize("raw", [False, True])
def test_the_callback_receives_the_messages_that_match_the_filter(*, raw: bool) -> None:
    inbox = list[Any]()
    listener = subscription(inbox.append, msg_type=Int64, raw=raw, content_filter=ABOVE_TWO)
    assert listener.is_cft_enabled
    received(listener, *numbers(0, 3, 2, 5))
    messages = [deserialize_message(data, Int64) if raw else data for data in inbox]
    assert [message.data for message in messages] == [3, 5]
    assert listener.received_count == 2


def test_a_filter_can_be_changed_and_removed() -> None:
    listener = subscription(msg_type=Int64)
    assert not listener.is_cft_enabled
    with pytest.raises(WrongStateError):
        listener.get_content_filter()
    listener.set_content_filter("data < %0", ["9"])
    assert listener.get_content_filter() == ("data < %0", ["9"])
    with pytest.raises(ContentFilterError):
        listener.set_content_filter("bogus < 3", [])
    assert listener.get_content_filter() == ("data < %0", ["9"])
    listener.set_content_filter("", [])
    assert not listener.is_cft_enabled


def test_a_raw_message_that_the_filter_cannot_decode_is_refused() -> None:
    inbox = list[Any]()
    listener = subscription(inbox.append, msg_type=Int64, raw="payload", content_filter=ABOVE_TWO)
    received(listener, sample(b"\xc1", 1), *numbers(0, 3))
    assert len(inbox) == 1
    assert listener.refused_count == 1


# -- messages that are taken without an executor ---------------------------------------------------


def waiting(*samples: Any, **facts: Any) -> Subscription[Any]:
    listener = subscription(qos=QoSProfile(history=HistoryPolicy.KEEP_ALL), **facts)
    context: Any = listener.context
    context.channel.samples.extend(samples)
    return listener


def test_taken_messages_have_their_info() -> None:
    listener = waiting(sample(String(data="a"), 4))
    taken = listener.take_message()
    assert taken is not None
    assert (taken[0], taken[1]["publication_sequence_number"]) == (String(data="a"), 4)
    assert listener.take_message() is None


def test_a_message_can_be_taken_as_cdr() -> None:
    taken = waiting(sample(String(data="a"), 1)).handle.take_message(raw=True)
    assert taken is not None
    assert deserialize_message(taken[0], String) == String(data="a")


def test_taken_messages_are_filtered() -> None:
    listener = waiting(*numbers(0, 3, 1, 4), msg_type=Int64, content_filter=ABOVE_TWO)
    taken = list(iter(listener.take_message, None))
    assert [message.data for message, _ in taken] == [3, 4]


def test_a_foreign_message_of_another_type_is_not_taken() -> None:
    listener = waiting(sample(packed({}), encoding=FLOAT32), sample(String(data="good"), 1))
    taken = listener.take_message()
    assert taken is not None
    assert taken[0] == String(data="good")
    assert listener.refused_count == 1
