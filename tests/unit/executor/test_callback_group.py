from __future__ import annotations

import gc
import threading

import pytest

from tests.conftest import in_threads
from zbot.executor.callback_group import (
    CallbackGroup,
    MutuallyExclusiveCallbackGroup,
    ReentrantCallbackGroup,
)


class Entity:
    pass


def test_a_reentrant_group_allows_every_callback() -> None:
    group, entity = ReentrantCallbackGroup(), Entity()
    for _ in range(3):
        assert group.can_execute(entity)
        assert group.beginning_execution(entity)
    assert group.ending_execution(entity) == []


def test_a_group_has_weak_references_to_its_entities() -> None:
    group, entity = ReentrantCallbackGroup(), Entity()
    group.add_entity(entity)
    assert [reference() for reference in group.entities] == [entity]


def test_an_exclusive_group_allows_one_callback_and_returns_waiting_ones_in_order() -> None:
    group, first, second, third = MutuallyExclusiveCallbackGroup(), Entity(), Entity(), Entity()
    assert group.beginning_execution(first)
    assert not group.can_execute(second)
    assert not group.beginning_execution(second)
    assert not group.beginning_execution(third)
    assert not group.beginning_execution(second)
    assert not group.beginning_execution(first)
    assert group.ending_execution(first) == [second]
    assert group.can_execute(second)
    assert group.beginning_execution(second)
    assert group.ending_execution(second) == [third]
    assert group.dismiss() == [first]
    assert group.dismiss() == []


def test_only_one_of_many_threads_reserves_an_exclusive_group() -> None:
    group, barrier = MutuallyExclusiveCallbackGroup(), threading.Barrier(8)
    entered: list[bool] = []

    def enter(_: int) -> None:
        barrier.wait()
        entered.append(group.beginning_execution(Entity()))

    in_threads(enter, 8)
    assert sorted(entered) == [False] * 7 + [True]


@pytest.mark.parametrize("kind", [MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup])
def test_a_group_knows_its_entities_and_keeps_none_alive(kind: type[CallbackGroup]) -> None:
    group, entity = kind(), Entity()
    group.add_entity(entity)
    assert group.has_entity(entity)
    assert not group.has_entity(Entity())
    del entity
    gc.collect()
    assert len(group._entities) == 0


def test_the_methods_of_the_base_class_are_not_implemented() -> None:
    for method in ("can_execute", "beginning_execution", "ending_execution"):
        with pytest.raises(NotImplementedError):
            getattr(CallbackGroup(), method)(Entity())
