"""ROS 2's `ros2node`, for programs that ask the graph for its nodes."""
