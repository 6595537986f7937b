"""Client of Nav2, grids of costs (ROS 2's package `nav2_simple_commander`), and files of maps."""
