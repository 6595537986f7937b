"""Function that evaluates a node's parameters."""

from zbot.launch.parameters import evaluate_parameters
