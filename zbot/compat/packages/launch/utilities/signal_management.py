"""Names of `launch.utilities` under the name of their own module."""

from zbot.launch.signal_manager import AsyncSafeSignalManager
