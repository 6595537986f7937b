"""Values that must have a type."""

from zbot.launch.substitution import SomeSubstitutionsType as SomeSubstitutionsType
from zbot.launch.substitution import is_a_substitution as is_substitution
from zbot.launch.substitution import normalize as normalize_to_list_of_substitutions
from zbot.launch.typed_value import AllowedTypesType as AllowedTypesType
from zbot.launch.typed_value import NormalizedValueType as NormalizedValueType
from zbot.launch.typed_value import SomeValueType as SomeValueType
from zbot.launch.typed_value import coerce_to_type as coerce_to_type
from zbot.launch.typed_value import normalize_typed_substitution as normalize_typed_substitution
from zbot.launch.typed_value import perform_typed_substitution as perform_typed_substitution

__all__ = ["is_substitution", "normalize_to_list_of_substitutions"]
