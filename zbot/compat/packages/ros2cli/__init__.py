"""ROS 2's `ros2cli`, for programs that query the graph with its node."""
