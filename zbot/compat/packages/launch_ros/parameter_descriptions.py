# Written by python -m zbot.compat.generator; do not edit.
"""Parameters with types, and parameter files."""

from zbot.launch.parameters import Parameter, ParameterFile, ParameterValue

__all__ = [
    "Parameter",
    "ParameterFile",
    "ParameterValue",
]
