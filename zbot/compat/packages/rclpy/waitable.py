"""ROS 2's `rclpy.waitable`: every name is zbot's."""

from zbot.waitable import NumberOfEntities as NumberOfEntities
from zbot.waitable import Waitable as Waitable
