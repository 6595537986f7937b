"""Tests of the sequence numbers and lifespans of publishers, and of the count of lost messages."""

from __future__ import annotations

import time
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest

from tests.unit.node.fakes import GID, TOPIC, sample
from tests.unit.tokens import endpoint_token
from zbot.names import ROSOUT_TOPIC
from zbot.node.message_sources import LostMessages, MessageSources
from zbot.node.refusals import Refusals
from zbot.qos import QoSProfile
from zbot.time import Duration, Infinite
from zbot.wire.dialect import NATIVE

from std_msgs.msg import String

if TYPE_CHECKING:
    from zbot.log.record import Record

SECOND = Duration(seconds=1)
FLOAT32 = "application/msgpack;std_msgs/msg/Float32"


def sources_of(
    lifespan: Duration | None = None, publisher_lifespan: Duration | None = None
) -> SimpleNamespace:
    """Return the sources, losses and refusals of a subscription, and its publisher."""
    qos = QoSProfile(depth=1, lifespan=lifespan)
    token = endpoint_token(TOPIC, qos=qos)
    publisher = endpoint_token(TOPIC, qos=QoSProfile(depth=1, lifespan=publisher_lifespan))
    losses = LostMessages(token, "listener")
    refusals = Refusals(NATIVE, token, "listener")
    sources = MessageSources(token, {publisher.gid: publisher}.get, refusals, losses)
    return SimpleNamespace(
        admits=sources.admits,
        by_gid=sources.by_gid,
        losses=losses,
        refusals=refusals,
        gid=publisher.gid,
    )


def admitted(sources: Any, *numbers: int, gid: bytes = GID) -> list[int]:
    message = sample(String(), 1)
    return [number for number in numbers if sources.admits(message, number, 0, gid)]


def test_the_first_number_of_a_publisher_is_no_loss() -> None:
    sources = sources_of()
    assert admitted(sources, 100, 101) == [100, 101]
    assert sources.losses.count == 0


def test_a_gap_counts_as_lost_messages() -> None:
    sources = sources_of()
    admitted(sources, 1, 2, 5, 6, 10)
    assert sources.losses.count == 5


def test_an_overtaken_message_does_not_count_later_ones_as_lost() -> None:
    sources = sources_of()
    assert admitted(sources, 1, 2, 4, 3, 5, 6) == [1, 2, 4, 3, 5, 6]
    assert sources.losses.count == 1


def test_each_publisher_has_its_own_numbers() -> None:
    sources = sources_of()
    admitted(sources, 1, 2)
    admitted(sources, 7, 8, gid=bytes(16))
    admitted(sources, 3)
    assert sources.losses.count == 0


def test_the_numbers_of_many_publishers_are_not_kept_for_ever() -> None:
    sources = sources_of()
    for number in range(3000):
        admitted(sources, 1, gid=number.to_bytes(16, "little"))
    assert len(sources.by_gid) <= 1024


@pytest.mark.parametrize(
    ("own", "publisher", "expected"),
    [
        (None, None, True),
        (Infinite, Infinite, True),
        (SECOND, None, False),
        (None, SECOND, False),
        (Infinite, SECOND, False),
        (SECOND, Infinite, False),
        (Duration(seconds=60), Duration(seconds=60), True),
        (Duration(seconds=60), SECOND, False),
    ],
)
def test_a_message_is_refused_after_the_shorter_lifespan(
    own: Duration | None, publisher: Duration | None, *, expected: bool
) -> None:
    sources = sources_of(own, publisher)
    two_seconds_ago = time.time_ns() - 2 * 10**9
    assert sources.admits(sample(String(), 1), 1, two_seconds_ago, sources.gid) is expected
    assert sources.admits(sample(String(), 2), 2, time.time_ns(), sources.gid)


def test_the_messages_of_a_publisher_with_another_type_are_refused_and_logged_once(
    logged: list[Record],
) -> None:
    sources = sources_of()
    wrong = sample(b"", 1, encoding=FLOAT32)
    assert [sources.admits(wrong, number, 0, GID) for number in (1, 2, 3)] == [False] * 3
    assert admitted(sources, 1, gid=bytes(16)) == [1]
    assert sources.refusals.count == 3
    (line,) = logged
    assert line.message == (
        "/chatter: cannot read a message: it is std_msgs/msg/Float32, not std_msgs/msg/String "
        "(more of this kind are only counted)"
    )


def test_a_single_lost_message_is_counted_in_the_singular(logged: list[Record]) -> None:
    LostMessages(endpoint_token(TOPIC, qos=QoSProfile(depth=5)), "listener").add(1)
    assert logged[0].message.startswith("/chatter: 1 message lost: ")


def test_only_the_first_loss_is_logged(logged: list[Record]) -> None:
    losses = LostMessages(endpoint_token(TOPIC, qos=QoSProfile(depth=5)), "listener")
    losses.add(95)
    losses.add(95)
    assert losses.count == 190
    (line,) = logged
    assert line.name == "listener"
    assert line.message == (
        "/chatter: 95 messages lost: they come faster than the callback takes them "
        "(queue depth 5; further losses are only counted)"
    )


def test_a_listener_gets_each_loss_and_nothing_is_logged(logged: list[Record]) -> None:
    losses, heard = LostMessages(endpoint_token(TOPIC), "listener"), list[int]()
    losses.listeners.append(heard.append)
    losses.add(3)
    losses.add(4)
    assert (heard, losses.count, logged) == ([3, 4], 7, [])


def test_a_loss_on_rosout_is_not_logged_on_rosout(logged: list[Record]) -> None:
    losses = LostMessages(endpoint_token(ROSOUT_TOPIC), "listener")
    losses.add(1)
    assert (losses.count, logged) == (1, [])
