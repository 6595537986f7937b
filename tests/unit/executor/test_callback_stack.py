"""Functions that are called at the end of a callback."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast

from zbot.executor.callback_stack import CallbackStack, current_executor, running_callbacks

if TYPE_CHECKING:
    from zbot.executor.executor import Executor

OUTER, INNER = cast("Any", "outer"), cast("Any", "inner")
EXECUTOR = cast("Executor", object())


def test_a_function_is_called_when_its_callback_ends() -> None:
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


def test_code_outside_of_callbacks_has_no_executor() -> None:
    assert current_executor() is None
    running_callbacks.stack.append((EXECUTOR, OUTER))
    assert current_executor() is EXECUTOR
    running_callbacks.pop()
    assert current_executor() is None
