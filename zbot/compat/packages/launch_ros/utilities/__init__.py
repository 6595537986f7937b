"""Helpers of launch files and their tests."""

from zbot.launch.actions.ros_names import absolute as make_namespace_absolute
from zbot.launch.actions.ros_names import join_namespace as prefix_namespace
from zbot.launch.parameters import evaluate_parameters as evaluate_parameters
from zbot.launch.parameters import normalize_parameters as normalize_parameters
