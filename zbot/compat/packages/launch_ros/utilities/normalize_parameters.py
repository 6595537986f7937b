"""What may be given as parameters."""

from zbot.launch.parameters import normalize_parameters as normalize_parameters
