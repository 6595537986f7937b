from __future__ import annotations

import queue
from typing import Any

import pytest

from zbot.classroom.student import link_check
from zbot.classroom.student.link_check import LinkCheck


class Hub:
    """Stands for the hub's process."""

    def __init__(self) -> None:
        self.reopenings = 0

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
