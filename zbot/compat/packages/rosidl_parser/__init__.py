"""ROS 2's `rosidl_parser`, as far as programs look at the types of fields."""
