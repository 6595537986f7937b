"""ROS 2's `ros2cli`, for programs that take its node for a look at the graph."""
