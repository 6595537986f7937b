"""Actions that run test programs."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

from zbot.launch.action import Action
from zbot.launch.actions.event_action import EmitEvent
from zbot.launch.actions.execute import ExecuteProcess
from zbot.launch.actions.timer import TimerAction
from zbot.launch.event import Event
from zbot.launch.process_event import ShutdownProcess, matches_action

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.launch.context import LaunchContext
    from zbot.launch.entity import LaunchDescriptionEntity

_WAIT = "import signal, sys, threading\nsignal.signal(signal.SIGINT, lambda *_: sys.exit(0))\n"


class Test(ExecuteProcess):
    """A test program that may have a time limit.

    Args:
        timeout: Seconds after which the launch ends the program. `None` means no limit.
        options: The options of `ExecuteProcess`.
    """

    __test__ = False  # not a test class of pytest

    def __init__(self, *, timeout: float | None = None, **options: Any) -> None:
        super().__init__(**options)
        self.timeout = timeout

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        """Start the program. If `timeout` is set, also start a timer that ends the program."""
        following = list(super().execute(context) or ())
        if self.timeout is not None:
            end = EmitEvent(event=ShutdownProcess(process_matcher=matches_action(self)))
            following.append(TimerAction(period=self.timeout, actions=[end]))
        return following


class GTest(Test):
    """A test program that uses GoogleTest.

    Args:
        path: The program.
        timeout: Seconds after which the launch ends the program.
        options: The options of `ExecuteProcess`.
    """

    def __init__(self, *, path: Any, timeout: float | None = None, **options: Any) -> None:
        super().__init__(cmd=[path], timeout=timeout, **options)


class PyTest(Test):
    """A run of pytest.

    Args:
        path: The file or folder with the tests.
        timeout: Seconds after which the launch ends pytest.
        options: The options of `ExecuteProcess`.
    """

    def __init__(self, *, path: Any, timeout: float | None = None, **options: Any) -> None:
        super().__init__(cmd=[sys.executable, "-m", "pytest", path], timeout=timeout, **options)


class ReadyToTestEvent(Event):
    """A launch reached its `ReadyToTest`."""

    __test__ = False  # not a test class of pytest
    name = "zbot.launch.ReadyToTestEvent"


class ReadyToTest(Action):
    """Action that lets the tests of the launch start. Without tests, it has no effect."""

    def execute(self, context: LaunchContext) -> None:
        """Emit the event for the test runner."""
        context.emit_event_sync(ReadyToTestEvent())


class KeepAliveProc(ExecuteProcess):
    """Keeps a launch running, even if the launch has nothing else to wait for."""

    def __init__(self) -> None:
        super().__init__(cmd=[sys.executable, "-c", f"{_WAIT}threading.Event().wait()"])
