"""`FindPackage` and `FindPackageShare` under the name of their own module."""

from zbot.launch.substitutions import FindPackage, FindPackagePrefix, FindPackageShare
