"""Types of arguments that contain a node's parameters."""

from zbot.launch.parameters import SomeParameters
