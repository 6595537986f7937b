"""Functions for values that must have a given type."""

from zbot.launch.substitution import SomeSubstitutionsType
from zbot.launch.substitution import normalize as normalize_to_list_of_substitutions
from zbot.launch.substitution import perform as perform_substitutions
from zbot.launch.typed_value import (
    AllowedTypesType,
    NormalizedValueType,
    SomeValueType,
    coerce_list,
    coerce_to_type,
    extract_type,
    get_typed_value,
    is_instance_of,
    is_instance_of_valid_type,
    is_normalized_substitution,
    is_substitution,
    is_typing_list,
    is_valid_scalar_type,
    normalize_typed_substitution,
    perform_typed_substitution,
)

# Extensions use these names in annotations. Their values have no effect in zbot.
AllowedValueType = ScalarValueType = ListValueType = SomeValueType
SomeScalarType = SomeSequenceType = StrSomeValueType = SomeValueType
StrSomeScalarType = StrSomeSequenceType = SomeValueType
NormalizedScalarType = NormalizedSequenceType = NormalizedValueType
ScalarTypesType = ListTypesType = AllowedTypesType

__all__ = ["normalize_to_list_of_substitutions", "perform_substitutions"]
