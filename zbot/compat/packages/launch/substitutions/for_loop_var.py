"""The values of loops under their own module's name."""

from zbot.launch.substitutions import ForEachVar as ForEachVar
from zbot.launch.substitutions import ForLoopIndex as ForLoopIndex
