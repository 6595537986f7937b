"""What can happen to processes."""

from zbot.launch.process_event import ProcessExited as ProcessExited
from zbot.launch.process_event import ProcessIO as ProcessIO
from zbot.launch.process_event import ProcessStarted as ProcessStarted
from zbot.launch.process_event import ProcessStderr as ProcessStderr
from zbot.launch.process_event import ProcessStdin as ProcessStdin
from zbot.launch.process_event import ProcessStdout as ProcessStdout
from zbot.launch.process_event import ProcessTargetedEvent as ProcessTargetedEvent
from zbot.launch.process_event import RunningProcessEvent as RunningProcessEvent
from zbot.launch.process_event import ShutdownProcess as ShutdownProcess
from zbot.launch.process_event import SignalProcess as SignalProcess
from zbot.launch.process_event import matches_action as matches_action
from zbot.launch.process_event import matches_executable as matches_executable
from zbot.launch.process_event import matches_name as matches_name
from zbot.launch.process_event import matches_pid as matches_pid
