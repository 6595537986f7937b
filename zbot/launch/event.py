"""Events: what happened, or what is to happen, for handlers to act on."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from zbot.launch.action import Action
    from zbot.launch.description import LaunchDescription


class Event:
    """Something that happened."""

    name = "launch.Event"


class Shutdown(Event):
    """The launch is to end.

    Args:
        reason: Why.
        due_to_sigint: Whether somebody pressed Ctrl-C.
    """

    name = "launch.events.Shutdown"

    def __init__(self, *, reason: str = "reason not given", due_to_sigint: bool = False) -> None:
        self.reason, self.due_to_sigint = reason, due_to_sigint


class ExecutionComplete(Event):
    """An action is done."""

    name = "launch.events.ExecutionComplete"

    def __init__(self, *, action: Action) -> None:
        self.action = action


class IncludeLaunchDescriptionEvent(Event):
    """A description is to be launched in addition."""

    name = "launch.events.IncludeLaunchDescription"

    def __init__(self, launch_description: LaunchDescription) -> None:
        self.launch_description = launch_description


class TimerEvent(Event):
    """A timer's time has come."""

    name = "launch.events.TimerEvent"

    def __init__(self, *, timer_action: Action) -> None:
        self.timer_action = timer_action


class TimerSkipped(Event):
    """Ctrl-C was pressed again: processes that do not end are to get the next signal now."""

    name = "zbot.launch.TimerSkipped"
