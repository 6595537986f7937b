"""Tests of the end of a bridge."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from zbot.bridge.bridge import _Failure


def test_the_first_error_of_another_thread_ends_the_bridge() -> None:
    done: list[str] = []
    context: Any = SimpleNamespace(interrupt=lambda: done.append("interrupted"))
    failure = _Failure(context)
    failure.raise_if_any()
    failure.note(OSError("no memory"))
    failure.note(OSError("closed"))
    assert done == ["interrupted", "interrupted"]
    with pytest.raises(OSError, match="no memory"):
        failure.raise_if_any()
