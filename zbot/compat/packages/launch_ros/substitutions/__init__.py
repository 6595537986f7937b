"""Substitutions for packages, their programs and parameters."""

from zbot.launch.substitutions import (
    ExecutableInPackage,
    FindPackage,
    FindPackagePrefix,
    FindPackageShare,
    Parameter,
)
