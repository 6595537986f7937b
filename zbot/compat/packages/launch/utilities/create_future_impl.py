"""Names of `launch.utilities` under the name of their own module."""

from zbot.launch.visit import create_future
