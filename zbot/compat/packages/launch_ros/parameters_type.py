"""What may be given as a node's parameters."""

from zbot.launch.parameters import SomeParameters as SomeParameters
