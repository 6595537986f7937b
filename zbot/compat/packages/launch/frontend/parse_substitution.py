"""Texts with substitutions."""

from zbot.launch.frontend.substitution_text import parse as parse_substitution
