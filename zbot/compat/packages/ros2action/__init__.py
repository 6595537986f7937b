"""ROS 2's `ros2action`, for programs that ask the graph for its actions."""
