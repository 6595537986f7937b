"""What a node's parameters are."""

from zbot.launch.parameters import evaluate_parameters as evaluate_parameters
