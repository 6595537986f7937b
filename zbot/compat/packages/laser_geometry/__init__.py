"""ROS 2's `laser_geometry`: laser scans as point clouds."""

from zbot.libraries.laser_projection import LaserProjection
