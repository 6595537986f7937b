"""`SomeSubstitutionsType` under its own module's name."""

from zbot.launch import SomeSubstitutionsType as SomeSubstitutionsType
