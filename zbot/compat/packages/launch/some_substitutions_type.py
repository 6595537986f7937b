"""What may be given where a text is wanted."""

from zbot.launch.substitution import SomeSubstitutionsType as SomeSubstitutionsType
from zbot.launch.substitution import (
    SomeSubstitutionsType_types_tuple as SomeSubstitutionsType_types_tuple,
)
