"""Tests of the topics that the panel Diagnostics receives."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

pytest.importorskip("nicegui", reason='the page needs NiceGUI: pip install "zbot[web]"')

from zbot.web.panels.diagnostics.panel import _Diagnostics

USUAL = ["/diagnostics", "/diagnostics_agg"]


class Watches:
    """Page that makes and drops watches."""

    def __init__(self) -> None:
        self.dropped: list[str] = []

    def watch(self, topic: str, *_: Any, **__: Any) -> Any:
        return SimpleNamespace(topic=topic, resume=lambda: None)

    def drop(self, watch: Any) -> None:
        self.dropped.append(watch.topic)


def panel(topic: str = "") -> Any:
    """Return a panel without elements that shows a topic."""
    made: Any = object.__new__(_Diagnostics)
    made.page, made.topic, made.number = Watches(), topic, 0
    made.watches, made.seen, made.logs = {}, {}, {}
    made.chooser = SimpleNamespace(set_options=lambda *_, **__: None, set_visibility=bool)
    made.list = SimpleNamespace(set_command=str)
    return made


def test_a_topic_that_has_gone_is_dropped_unless_it_is_shown() -> None:
    one = panel()
    one.match(["/a", "/b", "/c"])
    assert one.topic == "/a"
    assert sorted(one.watches) == ["/a", "/b", "/c", *USUAL]
    one.match(["/c"])
    assert sorted(one.watches) == sorted(one.logs) == sorted(one.seen) == ["/a", "/c", *USUAL]
    assert one.page.dropped == ["/b"]


def test_of_many_topics_the_first_ones_and_the_shown_one_are_received() -> None:
    one = panel("/t99")
    one.match([f"/t{number}" for number in range(10, 100)])
    assert sorted(one.watches) == [*USUAL, *(f"/t{number}" for number in range(10, 20)), "/t99"]


def test_a_name_of_the_address_that_is_no_topic_is_not_received() -> None:
    one = panel("no topic")
    one.match(["/a"])
    assert sorted(one.watches) == ["/a", *USUAL]
