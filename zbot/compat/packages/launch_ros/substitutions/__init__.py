"""Packages, their programs, and parameters, as texts."""

from zbot.launch.substitutions import ExecutableInPackage as ExecutableInPackage
from zbot.launch.substitutions import FindPackage as FindPackage
from zbot.launch.substitutions import FindPackagePrefix as FindPackagePrefix
from zbot.launch.substitutions import FindPackageShare as FindPackageShare
from zbot.launch.substitutions import Parameter as Parameter
