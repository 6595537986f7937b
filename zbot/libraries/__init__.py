"""Libraries of ROS 2 besides rclpy: cv_bridge, sensor_msgs_py and message_filters."""
