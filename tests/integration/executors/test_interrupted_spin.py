"""Tests of executors that spin again after an exception of a signal at any line of their code."""

from __future__ import annotations

import contextlib
import sys
import threading
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.integration.executors.conftest import BOTH
from zbot import executor as package
from zbot.executor.callback_stack import running_callbacks
from zbot.process.signals import MainThread

if TYPE_CHECKING:
    from collections.abc import Callable
    from types import FrameType

FOLDER = str(Path(package.__file__).parent)


class Interruption:
    """Profile function that raises `KeyboardInterrupt` at one step of the executors' code.

    Python lets signals interrupt it at these steps: when a function begins, and when a function
    that is written in C has returned.
    """

    def __init__(self, step: int) -> None:
        self.left = step

    def __call__(self, frame: FrameType, event: str, _argument: object) -> None:
        if event in {"call", "c_return"} and frame.f_code.co_filename.startswith(FOLDER):
            self.left -= 1
            if self.left == 0:
                raise KeyboardInterrupt


def is_interrupted(function: Callable[[], Any], step: int) -> bool:
    """Call a function, and interrupt it at a step. Return `False` if it has fewer steps."""
    interruption, before = Interruption(step), sys.getprofile()
    sys.setprofile(interruption)
    with contextlib.suppress(KeyboardInterrupt):
        function()
    sys.setprofile(before)
    return interruption.left <= 0


def spin_and_trigger(node: zbot.Node, executor: zbot.Executor) -> None:
    """Spin until a callback of the node's default group has run."""
    done: zbot.Future[int] = zbot.Future()
    guard = node.create_guard_condition(lambda: done.set_result(1))
    guard.trigger()
    executor.spin_until_future_complete(done, 2)
    node.destroy_guard_condition(guard)
    assert done.done()


@pytest.mark.parametrize("kind", BOTH)
def test_an_executor_spins_again_after_an_interruption_at_any_line(
    node: zbot.Node, kind: type[zbot.Executor]
) -> None:
    ticks: list[int] = []
    node.create_timer(0.001, lambda: ticks.append(1))
    step = 0
    is_long_enough = True
    while is_long_enough:
        step += 1
        with kind(context=node.context) as executor:
            done: zbot.Future[int] = zbot.Future()
            guard = node.create_guard_condition(lambda done=done: done.set_result(1))  # type: ignore[misc]
            guard.trigger()

            def spin(executor: zbot.Executor = executor, done: zbot.Future[int] = done) -> None:
                executor.add_node(node)
                executor.spin_until_future_complete(done, 2)

            is_long_enough = is_interrupted(spin, step)
            assert not executor.is_spinning
            assert not MainThread.spinning
            assert not running_callbacks.stack
            node.destroy_guard_condition(guard)

            executor.add_node(node)
            other = threading.Thread(target=spin_and_trigger, args=(node, executor))
            other.start()
            other.join(10)
            assert not other.is_alive()
            ticks.clear()
            spin_and_trigger(node, executor)
            while not ticks:
                executor.spin_once(2)
    assert step > 50
