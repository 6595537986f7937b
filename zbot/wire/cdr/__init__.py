"""CDR, the format of messages in ROS 2."""
