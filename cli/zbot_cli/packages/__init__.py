"""Packages of ROS 2 on disk: finding what they can run, creating and checking them."""
