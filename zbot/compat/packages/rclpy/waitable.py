"""ROS 2's `rclpy.waitable`: every name is zbot's."""

from zbot.executor.waitable import NumberOfEntities, Waitable
