from __future__ import annotations

from typing import Any

from zbot.executor.callback_group import ReentrantCallbackGroup
from zbot.executor.guard_condition import GuardCondition
from zbot.executor.ready_queue import ReadyQueue


def make(ready_queue: ReadyQueue) -> GuardCondition:
    guard = GuardCondition(None, ReentrantCallbackGroup(), ready_queue)
    ready_queue.add(guard)
    return guard


def test_a_post_goes_to_the_executor_that_is_attached() -> None:
    ready_queue, first, second = ReadyQueue(), list[Any](), list[Any]()
    guard = make(ready_queue)
    ready_queue.post(guard)
    ready_queue.attach("first", first.append)
    assert (first, ready_queue.executor) == ([guard], "first")
    ready_queue.post(guard)
    ready_queue.attach("second", second.append)
    ready_queue.post(guard)
    assert (first, second) == ([guard] * 2, [guard] * 2)
    assert ready_queue.executor == "second"


def test_nothing_is_posted_while_detached_and_everything_when_attached_again() -> None:
    ready_queue, posts = ReadyQueue(), list[Any]()
    guards = [make(ready_queue), make(ready_queue)]
    ready_queue.attach("executor", posts.append)
    ready_queue.detach()
    posts.clear()
    ready_queue.post(guards[0])
    assert (posts, ready_queue.executor) == ([], None)
    ready_queue.attach("executor", posts.append)
    assert posts == guards


def test_a_new_entity_is_posted_at_once() -> None:
    ready_queue, posts = ReadyQueue(), list[Any]()
    ready_queue.attach("executor", posts.append)
    assert posts == []
    guard = make(ready_queue)
    assert posts == [guard]


def test_a_removed_entity_is_forgotten() -> None:
    ready_queue, posts = ReadyQueue(), list[Any]()
    guard, other = make(ready_queue), make(ready_queue)
    assert ready_queue.entities == [guard, other]
    ready_queue.remove(guard)
    ready_queue.remove(guard)
    assert ready_queue.entities == [other]
    ready_queue.attach("executor", posts.append)
    assert posts == [other]
