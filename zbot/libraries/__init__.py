"""Libraries of ROS 2 besides rclpy, e.g. cv_bridge, sensor_msgs_py and message_filters."""
