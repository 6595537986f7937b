"""What launch files under test use."""

from __future__ import annotations

from zbot.launch.action import Action


class ReadyToTest(Action):
    """Marks where tests may begin; a launch without tests passes it by."""
