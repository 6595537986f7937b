"""Tests of the row of one parameter: which values it sends to the node."""

from __future__ import annotations

import asyncio
from types import SimpleNamespace
from typing import Any

import pytest

pytest.importorskip("nicegui", reason='the page needs NiceGUI: pip install "zbot[web]"')

from zbot.parameters.parameter import Parameter
from zbot.remote.service_calls import NoAnswerError
from zbot.web.panels.parameters.described_parameter import has_long_value
from zbot.web.panels.parameters.parameter_input import ParameterInput

ARRAY = Parameter.Type.DOUBLE_ARRAY


class FollowingRow(ParameterInput):
    """Row without elements that notes the values that it shows."""

    def __init__(self, value: list[float]) -> None:
        self._parameter = SimpleNamespace(type=ARRAY)  # type: ignore[assignment]
        self._is_long = has_long_value(ARRAY, value)
        self.shown: list[int] = []
        self._showers = [lambda value: self.shown.append(len(value))]


class Row(ParameterInput):
    """Row without elements. Its node does not answer to the values in `lost`."""

    def __init__(self, lost: set[float]) -> None:
        self._is_setting = False
        self._waiting = None
        self.lost = lost
        self.sent: list[float] = []

    async def _send(self, value: Any) -> None:
        self.sent.append(value)
        await asyncio.sleep(0)  # the other values come now
        if value in self.lost:
            raise NoAnswerError("/arm/set_parameters", 10.0)

    async def drag(self, *values: float) -> None:
        """Set values. All but the first one come before the node answers."""
        await asyncio.gather(*map(self._set, values), return_exceptions=True)


def test_only_the_last_value_of_a_drag_follows_the_first() -> None:
    row = Row(lost=set())
    asyncio.run(row.drag(0.1, 0.5, 1.7))
    assert row.sent == [0.1, 1.7]


def test_a_value_that_waited_for_a_lost_one_is_not_sent_later() -> None:
    row = Row(lost={0.1})
    asyncio.run(row.drag(0.1, 1.7))
    asyncio.run(row.drag(0.2))
    assert row.sent == [0.1, 0.2]


def test_a_list_that_becomes_too_long_for_an_input_needs_a_new_row() -> None:
    short, long = [0.5] * 1000, [0.5] * 1001
    row = FollowingRow(short)
    assert row.show(ARRAY, short)
    assert not row.show(ARRAY, long)
    assert not row.show(Parameter.Type.DOUBLE, 0.5)
    assert row.shown == [1000]
    assert FollowingRow(long).show(ARRAY, long)
