"""Functions that read strings with substitutions."""

from zbot.launch.frontend.substitution_text import parse as parse_substitution
from zbot.launch.frontend.substitution_text import parse_if_substitutions
