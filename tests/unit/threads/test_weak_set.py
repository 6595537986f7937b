"""Weak set that several threads use."""

from __future__ import annotations

import gc
import threading

from zbot.threads.weak_set import WeakSet


class Thing:
    """Object that can have weak references."""


def test_a_weak_set_keeps_nothing_alive() -> None:
    kept, dropped = Thing(), Thing()
    things = WeakSet([kept, dropped])
    del dropped
    gc.collect()
    assert list(things) == [kept]
    assert len(things) == 1


def test_a_weak_set_may_change_during_an_iteration() -> None:
    first, second = Thing(), Thing()
    things = WeakSet([first])
    for thing in things:
        things.add(second)
        things.discard(thing)
    assert list(things) == [second]


def test_other_threads_may_change_a_weak_set_during_an_iteration() -> None:
    things: WeakSet[Thing] = WeakSet()
    over = threading.Event()

    def change() -> None:
        while not over.is_set():
            fresh = [Thing() for _ in range(50)]
            for thing in fresh:
                things.add(thing)
            for thing in fresh[:25]:
                things.discard(thing)

    changing = threading.Thread(target=change)
    changing.start()
    try:
        for _ in range(2000):
            assert all(isinstance(thing, Thing) for thing in things)
    finally:
        over.set()
        changing.join()
