"""ROS 2's `launch_xml`: launch files in XML."""

from zbot.compat.submodules import submodules
from zbot.launch.frontend.parser import Parser
from zbot.launch.frontend.xml_file import Entity

__getattr__ = submodules(__name__, "launch_description_sources", "entity", "parser")
