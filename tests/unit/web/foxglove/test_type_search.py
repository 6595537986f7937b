"""Types that were not found are searched for again."""

from __future__ import annotations

import pytest

from zbot.remote.types import UnknownTypeError
from zbot.web.foxglove import type_search
from zbot.web.foxglove.type_search import TypeSearch

NAME = "robot_msgs/msg/Lamp"


class Nodes:
    """Nodes that answer only when they are awake."""

    def __init__(self) -> None:
        self.is_awake = False
        self.questions = 0

    def find(self, name: str) -> str:
        self.questions += 1
        if not self.is_awake:
            raise UnknownTypeError(name)
        return f"class of {name}"


@pytest.fixture
def nodes() -> Nodes:
    return Nodes()


@pytest.fixture
def search(nodes: Nodes) -> TypeSearch:
    return TypeSearch(nodes.find)


def fail(search: TypeSearch) -> None:
    with pytest.raises(UnknownTypeError, match=NAME):
        search.find(NAME)


def test_a_type_is_searched_for_again_after_a_pause(
    nodes: Nodes, search: TypeSearch, monkeypatch: pytest.MonkeyPatch
) -> None:
    fail(search)
    fail(search)  # in the pause, no node is asked
    assert nodes.questions == 1
    assert not search.is_due
    search.forget_unused([])
    monkeypatch.setattr(type_search, "_FIRST_PAUSE_S", 0.0)
    fail(search)
    assert search.is_due
    nodes.is_awake = True
    assert search.find(NAME) == f"class of {NAME}"
    assert nodes.questions == 3
    assert not search.is_due


def test_a_type_of_a_node_that_starts_again_is_new(nodes: Nodes, search: TypeSearch) -> None:
    fail(search)
    search.forget_unused([NAME])
    fail(search)
    assert nodes.questions == 1
    search.forget_unused(["std_msgs/msg/String"])
    fail(search)
    assert nodes.questions == 2
