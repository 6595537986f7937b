"""The common base classes of interface classes under ROS 2's name."""
