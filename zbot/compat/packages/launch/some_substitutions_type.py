# Written by python -m zbot.compat.generator; do not edit.
"""Type of arguments that are strings or substitutions."""

from zbot.launch.substitution import SomeSubstitutionsType, SomeSubstitutionsType_types_tuple

__all__ = [
    "SomeSubstitutionsType",
    "SomeSubstitutionsType_types_tuple",
]
