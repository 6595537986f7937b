"""The common bases of interface classes, by ROS 2's name."""
