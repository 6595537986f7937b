# Written by python -m zbot.compat.generator; do not edit.
"""Events of processes."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.process_event import (
    ProcessExited,
    ProcessIO,
    ProcessStarted,
    ProcessStderr,
    ProcessStdin,
    ProcessStdout,
    ProcessTargetedEvent,
    RunningProcessEvent,
    ShutdownProcess,
    SignalProcess,
    matches_action,
    matches_executable,
    matches_name,
    matches_pid,
)

__all__ = [
    "ProcessExited",
    "ProcessIO",
    "ProcessStarted",
    "ProcessStderr",
    "ProcessStdin",
    "ProcessStdout",
    "ProcessTargetedEvent",
    "RunningProcessEvent",
    "ShutdownProcess",
    "SignalProcess",
    "matches_action",
    "matches_executable",
    "matches_name",
    "matches_pid",
]

if TYPE_CHECKING:
    from . import process_exited as process_exited
    from . import process_io as process_io
    from . import process_matchers as process_matchers
    from . import process_started as process_started
    from . import process_stderr as process_stderr
    from . import process_stdin as process_stdin
    from . import process_stdout as process_stdout
    from . import process_targeted_event as process_targeted_event
    from . import running_process_event as running_process_event
    from . import shutdown_process as shutdown_process
    from . import signal_process as signal_process
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "process_exited",
            "process_io",
            "process_matchers",
            "process_started",
            "process_stderr",
            "process_stdin",
            "process_stdout",
            "process_targeted_event",
            "running_process_event",
            "shutdown_process",
            "signal_process",
        ),
    )[0]
