"""Variables of loops under the name of their own module."""

from zbot.launch.substitutions import ForEachVar, ForLoopIndex
