"""Bridge that carries topics, services and actions between zbot and ROS 2.

A side is one of the two worlds: `zbot_side` is a zbot context, and `rclpy_side` is a genuine rclpy.
Both have the methods of `side.Side`. `carrier.py` connects two sides, and does not know what they
are.
"""

from __future__ import annotations
