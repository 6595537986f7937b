"""Values that must have a type."""

from zbot.launch.substitution import SomeSubstitutionsType as SomeSubstitutionsType
from zbot.launch.substitution import normalize as normalize_to_list_of_substitutions
from zbot.launch.substitution import perform as perform_substitutions
from zbot.launch.typed_value import AllowedTypesType as AllowedTypesType
from zbot.launch.typed_value import NormalizedValueType as NormalizedValueType
from zbot.launch.typed_value import SomeValueType as SomeValueType
from zbot.launch.typed_value import coerce_list as coerce_list
from zbot.launch.typed_value import coerce_to_type as coerce_to_type
from zbot.launch.typed_value import extract_type as extract_type
from zbot.launch.typed_value import get_typed_value as get_typed_value
from zbot.launch.typed_value import is_instance_of as is_instance_of
from zbot.launch.typed_value import is_instance_of_valid_type as is_instance_of_valid_type
from zbot.launch.typed_value import is_normalized_substitution as is_normalized_substitution
from zbot.launch.typed_value import is_substitution as is_substitution
from zbot.launch.typed_value import is_typing_list as is_typing_list
from zbot.launch.typed_value import is_valid_scalar_type as is_valid_scalar_type
from zbot.launch.typed_value import normalize_typed_substitution as normalize_typed_substitution
from zbot.launch.typed_value import perform_typed_substitution as perform_typed_substitution

# What annotations of extensions name; a type checker sees ROS 2's own.
AllowedValueType = ScalarValueType = ListValueType = SomeValueType
SomeScalarType = SomeSequenceType = StrSomeValueType = SomeValueType
StrSomeScalarType = StrSomeSequenceType = SomeValueType
NormalizedScalarType = NormalizedSequenceType = NormalizedValueType
ScalarTypesType = ListTypesType = AllowedTypesType

__all__ = ["normalize_to_list_of_substitutions", "perform_substitutions"]
