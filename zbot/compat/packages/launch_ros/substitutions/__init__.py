# Written by python -m zbot.compat.generator; do not edit.
"""Substitutions for packages, their programs and parameters."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.substitutions import (
    ExecutableInPackage,
    FindPackage,
    FindPackagePrefix,
    FindPackageShare,
    Parameter,
)

__all__ = [
    "ExecutableInPackage",
    "FindPackage",
    "FindPackagePrefix",
    "FindPackageShare",
    "Parameter",
]

if TYPE_CHECKING:
    from . import executable_in_package as executable_in_package
    from . import find_package as find_package
    from . import parameter as parameter
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "executable_in_package",
            "find_package",
            "parameter",
        ),
    )[0]
