"""Components and parameters."""

from zbot.launch.actions.composable import ComposableNode
from zbot.launch.parameters import Parameter, ParameterFile, ParameterValue
