"""`LocalSubstitution` under its own module's name."""

from zbot.launch.substitutions import LocalSubstitution
