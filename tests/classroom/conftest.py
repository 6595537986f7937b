"""The testbed as a fixture."""

from __future__ import annotations

from contextlib import ExitStack
from typing import TYPE_CHECKING

import pytest

from tests.classroom.testbed import LanTestbed, missing_requirement

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator


def skip_without_namespaces() -> None:
    """Skip the test if this machine cannot make network namespaces."""
    reason = missing_requirement()
    if reason is not None:
        pytest.skip(reason)


@pytest.fixture
def make_testbed() -> Iterator[Callable[[int], LanTestbed]]:
    """Return a function that builds a classroom with some laptops."""
    skip_without_namespaces()
    with ExitStack() as stack:
        yield lambda laptops: stack.enter_context(LanTestbed(laptops))
