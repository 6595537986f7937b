"""Components and parameters."""

from zbot.launch.actions.composable import ComposableNode as ComposableNode
from zbot.launch.parameters import Parameter as Parameter
from zbot.launch.parameters import ParameterFile as ParameterFile
from zbot.launch.parameters import ParameterValue as ParameterValue
