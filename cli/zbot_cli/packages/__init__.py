"""Packages of ROS 2 on disk: their executables, creation and checks."""
