"""Action `ReadyToTest` of launch files under test, and its event."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.launch.action import Action
from zbot.launch.event import Event

if TYPE_CHECKING:
    from zbot.launch.context import LaunchContext


class ReadyToTestEvent(Event):
    """A launch reached its `ReadyToTest`."""

    __test__ = False  # not a test class of pytest
    name = "zbot.launch.ReadyToTestEvent"


class ReadyToTest(Action):
    """Action that lets the tests of the launch start. Without tests, it has no effect."""

    def execute(self, context: LaunchContext) -> None:
        """Emit the event for the test runner."""
        context.emit_event_sync(ReadyToTestEvent())
