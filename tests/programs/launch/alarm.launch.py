"""A guard that is woken each time it falls asleep, until the siren has been heard."""

import sys

from launch import LaunchDescription, LaunchDescriptionEntity
from launch.actions import EmitEvent, ExecuteProcess, LogInfo, RegisterEventHandler, TimerAction
from launch.event_handlers import OnExecutionComplete, OnProcessExit, OnProcessIO, OnProcessStart
from launch.events import Shutdown
from launch.events.process import ProcessIO

SIREN = "import sys; print('wail', file=sys.stderr)"


def heard(event: ProcessIO) -> LaunchDescriptionEntity | None:
    return LogInfo(msg="heard a wail") if b"wail" in event.text else None


def generate_launch_description() -> LaunchDescription:
    guard = ExecuteProcess(
        cmd=[sys.executable, "-c", "print('asleep')"],
        name="guard",
        output="screen",
        respawn=True,
        respawn_delay=0.05,
        respawn_max_retries=2,
    )
    siren = ExecuteProcess(cmd=[sys.executable, "-c", SIREN], name="siren", output="screen")
    later = TimerAction(period=0.05, actions=[siren])
    over = EmitEvent(event=Shutdown(reason="the guard is up"))
    return LaunchDescription(
        [
            RegisterEventHandler(
                OnProcessStart(target_action=siren, on_start=LogInfo(msg="the siren starts"))
            ),
            RegisterEventHandler(OnProcessIO(target_action=siren, on_stderr=heard)),
            RegisterEventHandler(OnProcessExit(target_action=siren, on_exit=[over])),
            RegisterEventHandler(
                OnExecutionComplete(target_action=guard, on_completion=[LogInfo(msg="up"), later])
            ),
            guard,
        ]
    )
