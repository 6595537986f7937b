"""Namespaces inside each other."""

from zbot.launch.actions.ros_names import absolute as make_namespace_absolute
from zbot.launch.actions.ros_names import join_namespace as prefix_namespace
