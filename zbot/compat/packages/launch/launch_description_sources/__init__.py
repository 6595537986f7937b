"""Where launch descriptions come from."""

from zbot.launch.source import AnyLaunchDescriptionSource as AnyLaunchDescriptionSource
from zbot.launch.source import FrontendLaunchDescriptionSource as FrontendLaunchDescriptionSource
from zbot.launch.source import PythonLaunchDescriptionSource as PythonLaunchDescriptionSource
