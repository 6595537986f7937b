"""The rig as a fixture."""

from __future__ import annotations

from contextlib import ExitStack
from typing import TYPE_CHECKING

import pytest

from tests.classroom.rig import Rig, obstacle

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator


@pytest.fixture
def make_rig() -> Iterator[Callable[[int], Rig]]:
    """Return a function that builds a classroom with some laptops."""
    reason = obstacle()
    if reason is not None:
        pytest.skip(reason)
    with ExitStack() as stack:
        yield lambda laptops: stack.enter_context(Rig(laptops))
