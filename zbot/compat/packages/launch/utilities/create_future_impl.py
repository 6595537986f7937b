"""What `launch.utilities` has, under its own module's name."""

from zbot.launch.visit import create_future as create_future
