"""Parameters with types, and parameter files."""

from zbot.launch.parameters import Parameter as Parameter
from zbot.launch.parameters import ParameterFile as ParameterFile
from zbot.launch.parameters import ParameterValue as ParameterValue
