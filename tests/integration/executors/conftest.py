"""Fixtures with a node and an executor, single-threaded or multi-threaded."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

import pytest

import zbot

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tests.conftest import MakeContext

BOTH = [zbot.SingleThreadedExecutor, zbot.MultiThreadedExecutor]


@pytest.fixture
def context(make_context: MakeContext) -> zbot.Context:
    return make_context()


@pytest.fixture
def node(context: zbot.Context) -> zbot.Node:
    return zbot.Node("worker", context=context)


@pytest.fixture(params=BOTH)
def executor(request: pytest.FixtureRequest, node: zbot.Node) -> Iterator[zbot.Executor]:
    with request.param(context=node.context) as made:
        made.add_node(node)
        yield made


@pytest.fixture
def single(node: zbot.Node) -> Iterator[zbot.SingleThreadedExecutor]:
    with zbot.SingleThreadedExecutor(context=node.context) as made:
        made.add_node(node)
        yield made


@pytest.fixture
def multi(node: zbot.Node) -> Iterator[zbot.MultiThreadedExecutor]:
    with zbot.MultiThreadedExecutor(4, context=node.context) as made:
        made.add_node(node)
        yield made


def complete(executor: zbot.Executor, future: zbot.Future[Any], timeout_sec: float = 5) -> Any:
    executor.spin_until_future_complete(future, timeout_sec)
    assert future.done()
    return future.result()


def run_ready_callbacks(executor: zbot.Executor) -> None:
    """Run ready callbacks until none is left."""
    marker: zbot.Future[bool] = zbot.Future()
    executor.create_task(lambda: executor.create_task(marker.set_result, True))
    complete(executor, marker)


class Overlap:
    """Counter of callbacks that run at the same time."""

    def __init__(self, expected: int) -> None:
        self.most = self._inside = self.calls = 0
        self._lock = threading.Lock()
        self._gate = threading.Barrier(expected)

    def visit(self, *, meet: bool) -> None:
        with self._lock:
            self._inside += 1
            self.calls += 1
            self.most = max(self.most, self._inside)
        if meet:
            self._gate.wait(5)
        else:
            threading.Event().wait(0.001)
        with self._lock:
            self._inside -= 1
