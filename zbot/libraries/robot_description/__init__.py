"""Reader of robot descriptions in URDF, as ROS 2 has in its packages urdf and urdfdom."""
