"""Parameters with types, and parameter files."""

from zbot.launch.parameters import Parameter, ParameterFile, ParameterValue
