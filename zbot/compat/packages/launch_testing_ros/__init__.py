"""ROS 2's `launch_testing_ros`: tests of launch files with nodes."""

from zbot.compat.submodules import submodules
from zbot.launch.testing.topics import WaitForTopics

__getattr__ = submodules(__name__, "actions", "tools", "wait_for_topics")
