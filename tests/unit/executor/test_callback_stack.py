"""What waits for the end of a callback."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast

from zbot.executor.callback_stack import CallbackStack, callbacks, current_executor

if TYPE_CHECKING:
    from zbot.executor.executor import Executor

OUTER, INNER = cast("Any", "outer"), cast("Any", "inner")
EXECUTOR = cast("Executor", object())


def test_each_callback_ends_with_what_was_asked_in_it() -> None:
    told: list[str] = []
    stack = CallbackStack()
    stack.stack.append((EXECUTOR, OUTER))
    stack.at_end(lambda: told.append("outer"))
    stack.stack.append((EXECUTOR, INNER))
    stack.at_end(lambda: told.append("inner"))
    assert told == []
    stack.pop()
    assert told == ["inner"]
    stack.pop()
    assert told == ["inner", "outer"]


def test_outside_of_callbacks_there_is_no_executor() -> None:
    assert current_executor() is None
    callbacks.stack.append((EXECUTOR, OUTER))
    assert current_executor() is EXECUTOR
    callbacks.pop()
    assert current_executor() is None
