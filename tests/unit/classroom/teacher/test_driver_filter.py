"""Tests of the filter between a class and its robot."""

from __future__ import annotations

import threading
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import zenoh

from tests.conftest import wait_until
from zbot.classroom.teacher import driver_filter
from zbot.classroom.teacher.driver_filter import DriverFilter

if TYPE_CHECKING:
    import pytest


def test_a_question_that_fails_does_not_end_the_filter(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[float] = []
    is_closed = threading.Event()

    def ask(*_: Any, timeout_s: float) -> list[Any]:
        asked.append(timeout_s)
        raise zenoh.ZError("the link broke")

    teacher = SimpleNamespace(load=lambda: SimpleNamespace(role="teacher"))
    monkeypatch.setattr(driver_filter, "membership", teacher)
    monkeypatch.setattr(driver_filter, "ask", ask)
    monkeypatch.setattr(driver_filter, "_ASK_S", 0.001)
    monkeypatch.setattr(driver_filter, "_LOST_S", 0.0)

    class Context:
        session = SimpleNamespace(declare_subscriber=lambda *_: None)

        @property
        def is_closed(self) -> bool:
            return is_closed.is_set()

        @staticmethod
        def receiver(function: Any, *, may_wait: bool) -> Any:
            assert may_wait
            return function

    stops: list[str] = []
    context: Any = Context()
    robot = DriverFilter(context, "arm", lambda: stops.append("stop"), lambda: stops.append("end"))
    robot.driver, robot._sessions = 17, {"ab"}  # as if a student drove
    robot.start()
    assert wait_until(lambda: len(asked) > 3)
    assert wait_until(lambda: stops == ["stop"])
    assert robot.driver is None
    is_closed.set()
    assert wait_until(lambda: not robot._thread.is_alive())
    robot.close()


def test_the_first_message_of_a_program_passes_before_its_tokens_were_noted() -> None:
    """The tokens are in Zenoh's queues when the message comes, but no thread has noted them."""
    endpoints: dict[bytes, Any] = {}
    sender = SimpleNamespace(zid="ab")
    graph = SimpleNamespace(find=endpoints.get, catch_up=lambda: endpoints.update({b"ana": sender}))
    context: Any = SimpleNamespace(graph=graph)
    robot = DriverFilter(context, "arm", lambda: None, lambda: None)
    assert not robot.admits("/beep", b"ana")  # nobody drives

    tokens: Any = SimpleNamespace(catch_up=lambda: robot._note(17, token("@/17/ab/0/0/NN")))
    robot.driver, robot._watch = 17, tokens
    assert robot.admits("/beep", b"ana")
    assert not robot.admits("/beep", b"ben")


def token(key: str) -> Any:
    return SimpleNamespace(key_expr=key, kind=zenoh.SampleKind.PUT)
