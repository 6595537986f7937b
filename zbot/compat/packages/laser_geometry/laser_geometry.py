"""The same name under its own module."""

from zbot.libraries.laser_projection import LaserProjection
