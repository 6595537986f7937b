"""Truth values."""

from zbot.launch.substitutions import AllSubstitution as AllSubstitution
from zbot.launch.substitutions import AndSubstitution as AndSubstitution
from zbot.launch.substitutions import AnySubstitution as AnySubstitution
from zbot.launch.substitutions import NotSubstitution as NotSubstitution
from zbot.launch.substitutions import OrSubstitution as OrSubstitution
