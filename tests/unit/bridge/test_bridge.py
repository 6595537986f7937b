"""Tests of the end of a bridge."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from zbot.bridge.bridge import _Failure, _spin
from zbot.errors import ExternalShutdownException


def spin(error: BaseException | None) -> tuple[_Failure, list[str]]:
    """Return what a thread has noted whose callback raises, and what it did with the context."""
    done: list[str] = []

    def run() -> None:
        if error is not None:
            raise error

    context: Any = SimpleNamespace(interrupt=lambda: done.append("interrupted"))
    executor: Any = SimpleNamespace(spin=run)
    failure = _Failure(context)
    _spin(executor, failure)
    return failure, done


def test_an_error_of_a_callback_on_the_side_of_ros_2_ends_the_bridge() -> None:
    failure, done = spin(OSError("no memory"))
    assert done == ["interrupted"]
    with pytest.raises(OSError, match="no memory"):
        failure.raise_if_any()


@pytest.mark.parametrize("error", [None, ExternalShutdownException()])
def test_a_usual_end_is_no_error(error: BaseException | None) -> None:
    failure, done = spin(error)
    assert done == []
    failure.raise_if_any()
