"""Libraries that ROS 2 ships beside rclpy: cv_bridge, sensor_msgs_py and message_filters."""
