"""ROS 2's `ros2service`, for programs that ask the graph for its services."""
