"""Sensors and plugins of Gazebo, of both generations, in robot descriptions and in SDF."""
