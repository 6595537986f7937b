"""Tests of a context's state, from `init()` to `shutdown()`, without a session."""

from __future__ import annotations

import pytest

from zbot.context.state import ContextState
from zbot.errors import ForkedProcessError, NotInitializedError, WrongStateError


class State(ContextState):
    """State whose `close` is noted."""

    def __init__(self) -> None:
        super().__init__()
        self.happened: list[str] = []

    def begin(self) -> State:
        self._require_new()
        self._begin()
        return self

    def close(self) -> None:
        self.happened.append("close")


def test_a_context_is_valid_from_init_to_shutdown() -> None:
    state = State()
    assert (state.ok(), state.is_valid, state.is_over) == (False, False, False)
    state.begin()
    assert (state.ok(), state.is_valid, state.is_over) == (True, True, False)
    state.shutdown()
    assert (state.ok(), state.is_valid, state.is_over) == (False, False, True)


def test_a_context_is_initialised_once() -> None:
    state = State().begin()
    with pytest.raises(WrongStateError):
        state.begin()
    state.shutdown()
    with pytest.raises(WrongStateError):
        state.begin()


def test_an_exception_of_a_callback_does_not_skip_the_others() -> None:
    state = State().begin()

    def fail() -> None:
        raise ValueError("full disk")

    state.on_shutdown(fail)
    state.on_shutdown(lambda: state.happened.append("saved"))
    with pytest.raises(ValueError, match="full disk"):
        state.shutdown()
    assert state.happened == ["saved", "close"]


def test_an_interrupted_context_is_not_ok_but_still_valid() -> None:
    state = State().begin()
    state.interrupt()
    assert state.is_interrupted
    assert (state.ok(), state.is_running, state.is_valid) == (False, False, True)
    state.require_valid("a node")


def test_the_session_is_closed_once_after_the_callbacks() -> None:
    state = State()
    state.on_shutdown(lambda: state.happened.append("early"))
    state.begin()
    state.on_shutdown(lambda: state.happened.append("late"))
    state.add_waker(lambda: state.happened.append("woken"))
    for end in (state.shutdown, state.try_shutdown, state.destroy):
        end()
    assert state.happened == ["woken", "early", "late", "close"]


def test_nothing_happens_at_the_shutdown_of_a_new_context() -> None:
    state = State()
    state.on_shutdown(lambda: state.happened.append("callback"))
    state.shutdown()
    assert (state.happened, state.is_over) == ([], False)


def test_the_session_is_closed_if_a_callback_fails() -> None:
    state = State().begin()

    def fail() -> None:
        raise ValueError("mine")

    state.on_shutdown(fail)
    with pytest.raises(ValueError, match="mine"):
        state.shutdown()
    assert state.happened == ["close"]


def test_a_shutdown_callback_must_be_a_function() -> None:
    with pytest.raises(TypeError, match="callback must be a function, not int: 3"):
        State().on_shutdown(3)  # type: ignore[arg-type]  # pyright: ignore[reportArgumentType]


def test_wakers_are_called_until_they_are_removed() -> None:
    state, woken = State().begin(), list[str]()

    def once() -> None:
        woken.append("once")
        state.remove_waker(once)

    state.add_waker(once)
    state.add_waker(lambda: woken.append("always"))
    state.interrupt()
    state.interrupt()
    state.remove_waker(once)
    assert woken == ["once", "always", "always"]


def test_what_needs_a_session_raises_before_init_and_after_shutdown() -> None:
    state = State()
    with pytest.raises(NotInitializedError):
        state.require_valid("a node")
    state.begin().shutdown()
    with pytest.raises(NotInitializedError):
        state.require_valid("a node")


def test_a_forked_child_has_a_context_of_its_parent(monkeypatch: pytest.MonkeyPatch) -> None:
    state, woken = State().begin(), list[str]()
    state.add_waker(lambda: woken.append("parent's thread"))
    assert not state.is_of_parent
    monkeypatch.setattr("os.getpid", lambda: -1)
    assert state.is_of_parent
    state.leave_to_parent()
    assert state.ok()
    with pytest.raises(ForkedProcessError):
        state.require_valid("a node")
    state.interrupt()
    assert woken == []
