"""Under its own module's name."""

from zbot.launch.substitutions import ExecutableInPackage as ExecutableInPackage
