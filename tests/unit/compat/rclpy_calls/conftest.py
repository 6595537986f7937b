"""Proxy of rclpy's objects, and a check that a test has used each of their members."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest
from rclpy.node import Node

from tests.unit.compat.rclpy_table import NAMES, absent_members, find

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from rclpy.context import Context


#: The members of each class that the running test has used.
USED: dict[str, set[str]] = {}


class InUse:
    """Proxy that records the used members of an object."""

    def __init__(self, path: str, entity: Any) -> None:
        self.entity = entity
        self._used = USED.setdefault(path, set())

    def __getattr__(self, member: str) -> Any:
        value = getattr(self.entity, member)
        self._used.add(member)
        return value


def made(path: str, *arguments: Any, **options: Any) -> InUse:
    """Return a new object of a class of rclpy, in its proxy."""
    module, _, name = path.rpartition(".")
    return InUse(path, find(module, name)(*arguments, **options))


def present(path: str) -> set[str]:
    """Return the members of a class that the page calls present."""
    module, _, name = path.rpartition(".")
    known = NAMES[module][name] or []
    return set(known) - set(absent_members(find(module, name), known))


@pytest.fixture(autouse=True)
def no_member_is_left_unused() -> Iterator[None]:
    USED.clear()
    yield
    assert {path: present(path) - used for path, used in USED.items() if present(path) - used} == {}


@pytest.fixture
def context(make_context: Callable[[], Context]) -> Context:
    return make_context()


@pytest.fixture
def node(context: Context) -> Node:
    return Node("caller", namespace="/calls", context=context)


def ignore(*_: object) -> None:
    return None
