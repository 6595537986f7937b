"""ROS 2's `ros2topic`, for programs that ask the graph for its topics."""
