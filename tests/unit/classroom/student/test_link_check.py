from __future__ import annotations

import queue
from typing import Any, cast

import pytest

from zbot.classroom.student import link_check
from zbot.classroom.student.link_check import LinkCheck


class Hub:
    """Stands for the hub's process."""

    def __init__(self) -> None:
        self.reopenings = 0
        self.session = None

    def is_linked(self) -> bool:
        return True

    def reopen(self) -> None:
        self.reopenings += 1


@pytest.mark.parametrize(
    ("found", "reopenings"),
    [
        ([set()], 0),
        ([{"/a"}, set()], 0),
        ([{"/a"}, {"/a"}], 1),
        ([{"/a"}, {"/b"}, set()], 0),
        ([{"/a"}, {"/b"}, {"/b"}, {"/b", "/c"}], 1),
    ],
)
def test_a_hub_is_reopened_if_the_same_is_missing_twice(
    monkeypatch: pytest.MonkeyPatch, found: list[set[str]], reopenings: int
) -> None:
    monkeypatch.setattr(link_check, "_CALM_S", 0.01)
    changes: queue.SimpleQueue[bool] = queue.SimpleQueue()
    answers = list(found)

    def missing(_self: LinkCheck, _serving: Any) -> set[str]:
        answer = answers.pop(0)
        if not answers:
            changes.put(False)  # the hub is closed after the last check
        return answer

    monkeypatch.setattr(LinkCheck, "_missing", missing)
    hub: Any = Hub()
    changes.put(True)
    LinkCheck(17, None)._run(hub, changes)
    assert hub.reopenings == reopenings
    assert not answers


@pytest.mark.parametrize(
    ("known", "told", "reopenings"),
    [
        (True, [None, None], 1),  # only the link is at fault
        (False, [None], 0),  # the class does not accept this laptop
        (None, [None], 0),  # the class is suspended
        (None, [None, {"nodes": [], "here": False}, {"nodes": [], "here": False}], 1),
    ],
)
def test_a_hub_is_reopened_only_if_the_class_answers_in_its_lobby(
    monkeypatch: pytest.MonkeyPatch,
    known: bool | None,
    told: list[dict[str, Any] | None],
    reopenings: int,
) -> None:
    monkeypatch.setattr(link_check, "_CALM_S", 0.01)
    changes: queue.SimpleQueue[bool] = queue.SimpleQueue()
    answers = list(told)

    def of_class() -> dict[str, Any] | None:
        answer = answers.pop(0)
        if not answers:
            changes.put(False)  # the hub is closed after the last check
        return answer

    monkeypatch.setattr(LinkCheck, "_missing_at_router", lambda *_: (frozenset(), set()))
    hub: Any = Hub()
    changes.put(True)
    LinkCheck(17, of_class, lambda: known)._run(hub, changes)
    assert hub.reopenings == reopenings
    assert not answers


def test_each_reopening_doubles_the_wait_until_another_link_is_lost(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    waits: list[float] = []

    def is_calm(_changes: Any, calm_s: float) -> bool:
        waits.append(calm_s)
        return True

    monkeypatch.setattr(link_check, "_is_calm", is_calm)
    monkeypatch.setattr(LinkCheck, "_missing", lambda *_: {"/a"})
    check, hub = LinkCheck(17, None), Hub()
    changes: Any = queue.SimpleQueue()

    def run(*, is_lost: bool) -> float:
        waits.clear()
        check._change(changes, is_lost=is_lost)
        changes.put(False)
        check._run(cast("Any", hub), changes)
        return waits[0]

    assert [run(is_lost=False) for _ in range(3)] == [1.0, 2.0, 4.0]
    assert run(is_lost=True) == 8.0  # reopening the hub loses all links
    check._is_reopening = False  # the hub is open again
    assert run(is_lost=True) == 1.0
