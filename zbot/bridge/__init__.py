"""Bridge that carries topics, services and actions between zbot and ROS 2.

`devices/` connects things that have no nodes: boards and MQTT brokers.

A side is one of the two systems that a bridge connects. `zbot_side` uses a zbot context.
`rclpy_side` uses a genuine rclpy, i.e. the rclpy of ROS 2 and not zbot's module of the same name.
Both sides have the methods of `side.Side`. `route_manager.py` connects two sides, and uses only
these methods.
"""

from __future__ import annotations
