"""Under its own module's name."""

from zbot.launch.substitutions import Parameter as Parameter
