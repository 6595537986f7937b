# Written by python -m zbot.compat.generator; do not edit.
"""Substitutions for packages, their programs and parameters."""

from typing import TYPE_CHECKING

from zbot.compat.first_use import at_first_use
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
    __getattr__ = at_first_use(
        __name__,
        "executable_in_package",
        "find_package",
        "parameter",
    )
