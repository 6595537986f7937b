"""What launch files under test use."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.launch.action import Action
from zbot.launch.event import Event

if TYPE_CHECKING:
    from zbot.launch.context import LaunchContext


class TestsMayBegin(Event):
    """A launch reached its `ReadyToTest`."""

    __test__ = False  # it is pytest's word for its own
    name = "zbot.launch.TestsMayBegin"


class ReadyToTest(Action):
    """Marks where tests may begin; a launch without tests passes it by."""

    def execute(self, context: LaunchContext) -> None:
        """Tell who runs the tests."""
        context.emit_event_sync(TestsMayBegin())
