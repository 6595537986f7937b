# Written by python -m zbot.compat.generator; do not edit.
"""Components and parameters."""

from typing import TYPE_CHECKING

from zbot.compat.first_use import at_first_use
from zbot.launch.actions.composable import ComposableNode
from zbot.launch.parameters import Parameter, ParameterFile, ParameterValue

__all__ = [
    "ComposableNode",
    "Parameter",
    "ParameterFile",
    "ParameterValue",
]

if TYPE_CHECKING:
    from . import composable_node as composable_node
else:
    __getattr__ = at_first_use(
        __name__,
        "composable_node",
    )
