"""Events of a launch. An event reports a change or requests an action."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from zbot.launch.action import Action
    from zbot.launch.description import LaunchDescription


class Event:
    """Base class of events."""

    name = "launch.Event"


class Shutdown(Event):
    """Request to shut the launch down.

    Args:
        reason: The reason that the log shows.
        due_to_sigint: Whether Ctrl-C caused the shutdown.
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
    """Request to launch one more description."""

    name = "launch.events.IncludeLaunchDescription"

    def __init__(self, launch_description: LaunchDescription) -> None:
        self.launch_description = launch_description


class TimerEvent(Event):
    """The period of a timer is over."""

    name = "launch.events.TimerEvent"

    def __init__(self, *, timer_action: Action) -> None:
        self.timer_action = timer_action


class SecondInterrupt(Event):
    """A second Ctrl-C. Processes that still run get the next signal immediately."""

    name = "zbot.launch.SecondInterrupt"
