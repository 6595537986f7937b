"""Test programs as actions."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

from zbot.launch.actions.event_action import EmitEvent
from zbot.launch.actions.execute import ExecuteProcess
from zbot.launch.actions.timer import TimerAction
from zbot.launch.process_event import ShutdownProcess, matches_action

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.launch.context import LaunchContext
    from zbot.launch.entity import LaunchDescriptionEntity


class Test(ExecuteProcess):
    """A test program, which may have a longest time.

    Args:
        timeout: Seconds after which it is ended; `None` for as long as it takes.
        options: As for `ExecuteProcess`.
    """

    __test__ = False  # it is pytest's word for its own

    def __init__(self, *, timeout: float | None = None, **options: Any) -> None:
        super().__init__(**options)
        self.timeout = timeout

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        """Start the program, and what is to end it."""
        following = list(super().execute(context) or ())
        if self.timeout is not None:
            end = EmitEvent(event=ShutdownProcess(process_matcher=matches_action(self)))
            following.append(TimerAction(period=self.timeout, actions=[end]))
        return following


class GTest(Test):
    """A program of GoogleTest.

    Args:
        path: The program.
        timeout: Seconds after which it is ended.
        options: As for `ExecuteProcess`.
    """

    def __init__(self, *, path: Any, timeout: float | None = None, **options: Any) -> None:
        super().__init__(cmd=[path], timeout=timeout, **options)


class PyTest(Test):
    """A file or folder of pytest.

    Args:
        path: What pytest is to run.
        timeout: Seconds after which it is ended.
        options: As for `ExecuteProcess`.
    """

    def __init__(self, *, path: Any, timeout: float | None = None, **options: Any) -> None:
        super().__init__(cmd=[sys.executable, "-m", "pytest", path], timeout=timeout, **options)
