"""The log of a launch."""

from zbot.compat.submodules import submodules
from zbot.launch.logger import get_logger as get_logger
from zbot.launch.logger import launch_config as launch_config

__getattr__ = submodules(__name__, "handlers")
