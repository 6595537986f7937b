"""ROS 2's `launch_yaml`: launch files in YAML."""

from zbot.compat.submodules import submodules
from zbot.launch.frontend.parser import Parser
from zbot.launch.frontend.yaml_file import Entity

__getattr__ = submodules(__name__, "launch_description_sources", "parser")
