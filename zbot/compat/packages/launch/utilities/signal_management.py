"""What `launch.utilities` has, under its own module's name."""

from zbot.launch.signal_manager import AsyncSafeSignalManager as AsyncSafeSignalManager
