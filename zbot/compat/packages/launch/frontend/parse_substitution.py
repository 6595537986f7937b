# Written by python -m zbot.compat.generator; do not edit.
"""Functions that read strings with substitutions."""

from zbot.launch.frontend.substitution_text import (
    parse as parse_substitution,
    parse_if_substitutions,
)

__all__ = [
    "parse_if_substitutions",
    "parse_substitution",
]
