"""ROS 2's `rclpy.experimental.events_executor`: zbot's own executor is driven by events."""

from zbot.executor.single_threaded_executor import SingleThreadedExecutor as EventsExecutor

__all__ = ["EventsExecutor"]
