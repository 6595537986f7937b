"""What to do when something happens."""

from zbot.launch.event_handler import OnActionEventBase as OnActionEventBase
from zbot.launch.event_handler import OnExecutionComplete as OnExecutionComplete
from zbot.launch.event_handler import OnIncludeLaunchDescription as OnIncludeLaunchDescription
from zbot.launch.event_handler import OnProcessExit as OnProcessExit
from zbot.launch.event_handler import OnProcessIO as OnProcessIO
from zbot.launch.event_handler import OnProcessStart as OnProcessStart
from zbot.launch.event_handler import OnShutdown as OnShutdown
