"""Tests of the curves of a bag that a user chooses."""

from __future__ import annotations

import asyncio
from typing import Any

import pytest

from zbot.observer.errors import ViewerError
from zbot.web.panels.bags.bag_curves import BagCurves


def curve(name: str) -> dict[str, Any]:
    return {"name": name}


def test_a_curve_is_read_once() -> None:
    reads: list[str] = []

    async def read(name: str) -> dict[str, Any]:
        reads.append(name)
        return curve(name)

    async def run() -> None:
        curves = BagCurves(read)
        assert await curves.choose(["a"]) == [curve("a")]
        assert await curves.choose(["b", "a"]) == [curve("b"), curve("a")]
        assert await curves.choose([]) == []

    asyncio.run(run())
    assert reads == ["a", "b"]


def test_a_curve_that_cannot_be_read_is_read_again() -> None:
    reads: list[str] = []

    async def read(name: str) -> dict[str, Any]:
        reads.append(name)
        if len(reads) == 1:
            raise ViewerError(name)
        return curve(name)

    async def run() -> None:
        curves = BagCurves(read)
        with pytest.raises(ViewerError):
            await curves.choose(["a"])
        assert await curves.choose(["a"]) == [curve("a")]

    asyncio.run(run())


def test_the_answer_to_an_older_choice_is_dropped() -> None:
    async def run() -> None:
        is_read = asyncio.Event()

        async def read(name: str) -> dict[str, Any]:
            if name == "slow":
                await is_read.wait()
            return curve(name)

        curves = BagCurves(read)
        older = asyncio.ensure_future(curves.choose(["fast", "slow"]))
        await asyncio.sleep(0)
        assert await curves.choose(["fast"]) == [curve("fast")]
        is_read.set()
        assert await older is None

    asyncio.run(run())
