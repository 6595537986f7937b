"""Type of arguments that are strings or substitutions."""

from zbot.launch.substitution import (
    SomeSubstitutionsType,
    SomeSubstitutionsType_types_tuple,
)
