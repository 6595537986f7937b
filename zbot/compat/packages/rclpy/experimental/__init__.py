"""ROS 2's `rclpy.experimental`: zbot's own executor is driven by events."""

from zbot.compat.submodules import submodules
from zbot.executor.single_threaded_executor import SingleThreadedExecutor as EventsExecutor

__all__ = ["EventsExecutor"]
__getattr__ = submodules(__name__, "events_executor")
