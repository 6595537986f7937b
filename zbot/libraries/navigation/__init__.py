"""Client of Nav2, and grids of costs: ROS 2's package `nav2_simple_commander`."""
