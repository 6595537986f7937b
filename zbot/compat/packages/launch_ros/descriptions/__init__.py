# Written by python -m zbot.compat.generator; do not edit.
"""Components and parameters."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
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
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "composable_node",
        ),
    )[0]
