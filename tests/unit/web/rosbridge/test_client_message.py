from __future__ import annotations

from typing import Any

import pytest

from zbot.observer.serving.client_budget import MAX_MESSAGE_BYTES
from zbot.web.rosbridge import client_message
from zbot.web.rosbridge.client_message import (
    ClientMessage,
    Fragments,
    RosbridgeError,
    read_message,
)


def test_message_has_its_operation_and_id() -> None:
    message = read_message('{"op": "subscribe", "id": 7, "topic": "/scan"}')
    assert (message.op, message.id, message.word("topic")) == ("subscribe", 7, "/scan")


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "not valid JSON"),
        ("[]", "not an object"),
        ("{}", "'op' must be a string"),
        ('{"op": 5}', "'op' must be a string"),
        ('{"op": ""}', "'op' must be a string"),
        ('{"op": "publish", "id": {}}', "'id' must be a string or an integer"),
        ('{"op": "publish", "id": true}', "'id' must be a string or an integer"),
        ('{"op": "publish", "id": "' + "x" * 1001 + '"}', "'id' is longer than 1000"),
        ('{"op": "publish", "msg": ' + "[" * 70 + "]" * 70 + "}", "deeper than 64 levels"),
        ('{"op": "publish", "msg": NaN}', "NaN is not a number"),
        (" " * (MAX_MESSAGE_BYTES + 1), "longer than"),
        (b"\x00", "send JSON as text"),
    ],
)
def test_other_texts_are_refused_with_a_reason(text: str | bytes, reason: str) -> None:
    with pytest.raises(RosbridgeError, match=reason):
        read_message(text)


@pytest.mark.parametrize("value", [True, "5", [], -1, 1e10])
def test_a_number_must_be_one_in_its_range(value: Any) -> None:
    message = ClientMessage({"op": "subscribe", "throttle_rate": value})
    with pytest.raises(RosbridgeError, match="'throttle_rate' must be"):
        message.number("throttle_rate", 0)


def test_null_is_the_default() -> None:
    message = ClientMessage({"op": "subscribe", "a": None, "b": None, "c": None})
    assert message.number("a", 3) == 3
    assert message.word("b", "none") == "none"
    assert message.flag("c", default=True) is True


def fragment(number: int, total: int, data: str, id_: Any = "a") -> ClientMessage:
    fields = {"op": "fragment", "id": id_, "num": number, "total": total, "data": data}
    return ClientMessage(fields)


def test_fragments_are_joined_in_any_order() -> None:
    fragments = Fragments()
    assert fragments.add(fragment(2, 3, "c")) is None
    assert fragments.add(fragment(0, 2, "x", "b")) is None
    assert fragments.add(fragment(0, 3, "a")) is None
    assert fragments.add(fragment(1, 3, "b")) == "abc"
    assert fragments.add(fragment(1, 2, "y", "b")) == "xy"
    assert fragments.add(fragment(0, 1, "again")) == "again"


@pytest.mark.parametrize(("number", "total"), [(1, 1), (-1, 2), (0, 0)])
def test_a_fragment_outside_its_message_is_refused(number: int, total: int) -> None:
    with pytest.raises(RosbridgeError):
        Fragments().add(fragment(number, total, "a"))


def test_the_total_may_not_change() -> None:
    fragments = Fragments()
    fragments.add(fragment(0, 3, "a"))
    with pytest.raises(RosbridgeError, match="same total"):
        fragments.add(fragment(1, 4, "b"))


def test_fragments_cannot_fill_the_memory() -> None:
    fragments = Fragments()
    half = "x" * (MAX_MESSAGE_BYTES // 2)
    fragments.add(fragment(0, 9, half))
    with pytest.raises(RosbridgeError, match="oldest one is forgotten"):
        fragments.add(fragment(0, 9, half, "b"))
    assert fragments.add(fragment(1, 9, "", "b")) is None
    for number in range(15):
        fragments.add(fragment(0, 9, "", number))
    with pytest.raises(RosbridgeError, match="too many"):
        fragments.add(fragment(0, 9, "", "last"))


def test_empty_fragments_cannot_fill_the_memory(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(client_message, "MAX_MESSAGE_BYTES", 1000)
    fragments = Fragments()
    for number in range(10):
        fragments.add(fragment(number, 1000, ""))
    with pytest.raises(RosbridgeError, match="oldest one is forgotten"):
        fragments.add(fragment(10, 1000, ""))
