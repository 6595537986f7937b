"""The testbed and the school as fixtures."""

from __future__ import annotations

from contextlib import ExitStack
from typing import TYPE_CHECKING

import pytest

from tests.classroom.local_machine import LocalMachine
from tests.classroom.school import School
from tests.classroom.testbed import LanTestbed, missing_requirement

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

    from tests.conftest import Start


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


@pytest.fixture
def make_machine(tmp_path: Path) -> Iterator[Callable[[str], LocalMachine]]:
    """Return a function that makes machines. At the end they are switched off."""
    made: dict[str, LocalMachine] = {}

    def make(name: str) -> LocalMachine:
        return made.setdefault(name, LocalMachine(tmp_path / name))

    yield make
    for machine in reversed(made.values()):
        machine.switch_off()


@pytest.fixture
def school(
    make_machine: Callable[[str], LocalMachine], start: Start, monkeypatch: pytest.MonkeyPatch
) -> School:
    monkeypatch.delenv("ZBOT_DOMAIN_ID")  # a student's domain is his number
    return School(make_machine, start)
