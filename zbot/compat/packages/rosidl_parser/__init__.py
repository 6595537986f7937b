"""ROS 2's `rosidl_parser`: the part that describes types of fields."""
