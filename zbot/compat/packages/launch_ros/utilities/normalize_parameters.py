"""Function that normalizes a node's parameters."""

from zbot.launch.parameters import normalize_parameters
