"""A talker and a listener in two sessions, and what their tests look at."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import msgpack  # type: ignore[import-untyped]
import pytest

import zbot
from tests.conftest import wait_until
from zbot.qos import HistoryPolicy, QoSProfile

if TYPE_CHECKING:
    from tests.conftest import MakeContext
    from zbot.log.record import Record

KEEP_ALL = QoSProfile(history=HistoryPolicy.KEEP_ALL)


@pytest.fixture
def talker(make_context: MakeContext) -> zbot.Node:
    return zbot.Node("talker", context=make_context())


@pytest.fixture
def listener(make_context: MakeContext) -> zbot.Node:
    return zbot.Node("listener", context=make_context())


def packed(value: object) -> bytes:
    data: bytes = msgpack.Packer().pack(value)
    return data


def await_match(publisher: zbot.Publisher[Any], count: int = 1) -> None:
    assert wait_until(lambda: publisher.get_subscription_count() == count)


def lines_about(logged: list[Record], text: str) -> list[str]:
    return [record.message for record in logged if text in record.message]
