"""ROS 2's `ros2param`, for programs that ask other nodes for their parameters."""
