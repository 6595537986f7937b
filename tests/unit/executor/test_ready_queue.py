from __future__ import annotations

from typing import Any

from zbot.executor.callback_group import ReentrantCallbackGroup
from zbot.executor.guard_condition import GuardCondition
from zbot.executor.ready_queue import Mailbox


def make(mailbox: Mailbox) -> GuardCondition:
    guard = GuardCondition(None, ReentrantCallbackGroup(), mailbox)
    mailbox.add(guard)
    return guard


def test_a_post_goes_to_the_executor_that_is_attached() -> None:
    mailbox, first, second = Mailbox(), list[Any](), list[Any]()
    guard = make(mailbox)
    mailbox.post(guard)
    mailbox.attach("first", first.append)
    assert (first, mailbox.executor) == ([guard], "first")
    mailbox.post(guard)
    mailbox.attach("second", second.append)
    mailbox.post(guard)
    assert (first, second) == ([guard] * 2, [guard] * 2)
    assert mailbox.executor == "second"


def test_nothing_is_posted_while_detached_and_everything_when_attached_again() -> None:
    mailbox, posts = Mailbox(), list[Any]()
    guards = [make(mailbox), make(mailbox)]
    mailbox.attach("executor", posts.append)
    mailbox.detach()
    posts.clear()
    mailbox.post(guards[0])
    assert (posts, mailbox.executor) == ([], None)
    mailbox.attach("executor", posts.append)
    assert posts == guards


def test_a_new_entity_is_asked_at_once() -> None:
    mailbox, posts = Mailbox(), list[Any]()
    mailbox.attach("executor", posts.append)
    assert posts == []
    guard = make(mailbox)
    assert posts == [guard]


def test_a_removed_entity_is_forgotten() -> None:
    mailbox, posts = Mailbox(), list[Any]()
    guard, other = make(mailbox), make(mailbox)
    assert guard in mailbox
    mailbox.remove(guard)
    mailbox.remove(guard)
    assert guard not in mailbox
    assert mailbox.entities == [other]
    mailbox.attach("executor", posts.append)
    assert posts == [other]
