"""Under its own module's name."""

from zbot.launch.substitutions import FindPackage as FindPackage
from zbot.launch.substitutions import FindPackagePrefix as FindPackagePrefix
from zbot.launch.substitutions import FindPackageShare as FindPackageShare
