"""Functions that check and convert typed values, as in `launch.utilities.type_utils`."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, Final, TypeAlias, get_args, get_origin

from zbot.errors import shortened
from zbot.launch.errors import CoercionError, EntityTypeError
from zbot.launch.substitution import Substitution, normalize, perform
from zbot.text.yaml_reader import YamlError, read_yaml

if TYPE_CHECKING:
    from zbot.launch.context import LaunchContext

#: A string, number, bool or substitution, or a list of substitutions and values of one type.
SomeValueType: TypeAlias = Any
NormalizedValueType: TypeAlias = Any
AllowedTypesType: TypeAlias = Any

_SCALARS: Final = (int, float, bool, str)


#: The types that attributes in XML and YAML files can contain. The keys are the texts in the files.
#: `yaml` means that the value is read as YAML.
TYPES_BY_NAME: Final[dict[str, Any]] = {
    **{kind.__name__: kind for kind in _SCALARS},
    "list_of_bool": list[bool],
    "list_of_float": list[float],
    "list_of_int": list[int],
    "list_of_str": list[str],
    "yaml": None,
}


def get_data_type_from_identifier(type_identifier: str) -> Any:
    """Return the type that has a name such as `int` or `list_of_int`.

    Raises:
        CoercionError: No type has this name.
    """
    if type_identifier not in TYPES_BY_NAME:
        known = ", ".join(TYPES_BY_NAME)
        raise CoercionError(f"the type must be one of {known}, not '{type_identifier}'")
    return TYPES_BY_NAME[type_identifier]


def is_typing_list(data_type: Any) -> bool:
    """Return whether a type is `List` or `List[...]`."""
    return get_origin(data_type) is list


def is_valid_scalar_type(data_type: Any) -> bool:
    """Return whether a type is `bool`, `int`, `float` or `str`."""
    return data_type in _SCALARS


def extract_type(data_type: AllowedTypesType) -> tuple[Any, bool]:
    """Return a scalar type, and whether the given type is a list.

    The scalar type is the type of the list's items, or the given type itself.

    Raises:
        CoercionError: The type is not supported.
    """
    is_list = is_typing_list(data_type)
    (kind,) = (get_args(data_type) or (None,)) if is_list else (data_type,)
    if not is_valid_scalar_type(kind):
        expected = "bool, int, float, str or a List of one of these"
        raise CoercionError(f"the type must be {expected}, not {data_type}")
    return kind, is_list


def is_instance_of_valid_type(value: Any, can_be_str: bool = False) -> bool:
    """Return whether a value is a scalar, or a list whose scalars have the same type.

    Args:
        value: The value.
        can_be_str: Whether a list may also contain strings.
    """
    if not isinstance(value, list):
        return isinstance(value, _SCALARS)
    kinds = {type(item) for item in value} - ({str} if can_be_str else set())
    return len(kinds) <= 1 and all(map(is_valid_scalar_type, kinds))


def is_instance_of(value: Any, data_type: Any = None, can_be_str: bool = False) -> bool:
    """Return whether a value has a given type.

    Args:
        value: The value.
        data_type: The type, as for `extract_type`. `None` means any valid type.
        can_be_str: Whether strings are accepted too.

    Raises:
        CoercionError: The type is not supported.
    """
    if data_type is None:
        return is_instance_of_valid_type(value, can_be_str)
    kind, is_list = extract_type(data_type)
    kinds = (kind, str) if can_be_str else (kind,)
    if is_list:
        return isinstance(value, list) and all(isinstance(item, kinds) for item in value)
    return isinstance(value, kinds)


def coerce_to_type(value: str, data_type: Any = None, can_be_str: bool = False) -> Any:
    """Convert a string to a value.

    Args:
        value: The string.
        data_type: `bool`, `int`, `float`, `str`, or a list whose items have one of these types,
            e.g. `List[int]`. With `None`, the string is read as YAML.
        can_be_str: Whether to return the string itself if it cannot be converted.

    Raises:
        CoercionError: The string cannot be converted to this type.
        EntityTypeError: `value` is not a string.
    """
    if not isinstance(value, str):
        raise EntityTypeError("the value", "a str", value)
    if data_type is None:
        return _by_yaml(value, None, can_be_str)
    kind, is_list = extract_type(data_type)
    if is_list:
        return _list_of(value, kind, can_be_str)
    if kind is str:
        return value
    try:
        if kind is not bool:
            return kind(value)
    except (ValueError, OverflowError):
        if kind is int:
            return _without_type(value, kind, can_be_str)
    return _by_yaml({"1": "true", "0": "false"}.get(value, value), kind, can_be_str)


def _by_yaml(value: str, kind: Any, can_be_str: bool) -> Any:
    """Return the value that YAML reads from a text, e.g. the float of `.inf`."""
    try:
        found = read_yaml(value) if value else value
    except YamlError:
        found = None
    if kind is float and type(found) is int:
        return float(found)
    if is_instance_of(found, kind, can_be_str and not isinstance(found, str)):
        return found
    return _without_type(value, kind, can_be_str)


def _without_type(value: str, kind: Any, can_be_str: bool) -> str:
    if not can_be_str:
        raise CoercionError(f"{shortened(value)} is not a value of type {type_name(kind)}")
    return value


def _list_of(value: str, kind: Any, can_be_str: bool) -> list[Any]:
    """Return the items of a list in YAML. The type decides how the text of each item is read."""
    try:
        items = read_yaml(value, as_strings=True)
        if isinstance(items, list) and all(isinstance(item, str) for item in items):
            return [coerce_to_type(item, kind, can_be_str) for item in items]
    except (YamlError, CoercionError):
        pass
    raise CoercionError(f"{shortened(value)} is not a value of type {type_name(list[kind])}")


def type_name(data_type: Any) -> str:
    """Return a type for `coerce_to_type` as the text of an error."""
    if data_type is None:
        return "bool, number, text or a list of one of these"
    return str(data_type) if is_typing_list(data_type) else str(data_type.__name__)


def coerce_list(value: list[str], data_type: Any = None, can_be_str: bool = False) -> list[Any]:
    """Convert the strings of a list to values. All values have the same type.

    Args:
        value: The strings.
        data_type: The type of the items. With `None`, each string is read as YAML.
        can_be_str: Whether the result may also contain strings.

    Raises:
        CoercionError: The strings cannot be converted to the same type.
        EntityTypeError: `value` is not a list of strings.
    """
    if not isinstance(value, list):
        raise EntityTypeError("the value", "a list", value)
    found = [coerce_to_type(item, data_type, can_be_str) for item in value]
    if not is_instance_of_valid_type(found, can_be_str):
        raise CoercionError(f"the items of a list must have one type: {value}")
    return found


def get_typed_value(value: str | list[str], data_type: Any = None, can_be_str: bool = False) -> Any:
    """Convert a string or a list of strings. See `coerce_to_type` and `coerce_list`.

    Raises:
        CoercionError: The string cannot be converted to this type.
        EntityTypeError: `value` is not a string or a list. Or `value` is a list, but `data_type` is
            a scalar type.
    """
    if not isinstance(value, list):
        return coerce_to_type(value, data_type, can_be_str)
    kind, is_list = (None, True) if data_type is None else extract_type(data_type)
    if not is_list:
        raise EntityTypeError("the value", type_name(data_type), value)
    return coerce_list(value, kind, can_be_str)


def is_substitution(value: Any) -> bool:
    """Return whether a value is a substitution, or a list of strings and substitutions."""
    if not isinstance(value, Iterable):
        return isinstance(value, Substitution)
    parts = list(value)
    has_one = any(isinstance(part, Substitution) for part in parts)
    return has_one and all(isinstance(part, (str, Substitution)) for part in parts)


def is_normalized_substitution(value: Any) -> bool:
    """Return whether a value is a list of one or more substitutions."""
    is_filled = isinstance(value, list) and bool(value)
    return is_filled and all(isinstance(item, Substitution) for item in value)


def normalize_typed_substitution(value: SomeValueType, data_type: Any = None) -> Any:
    """Return a value after `normalize` of each substitution in it. Other parts stay unchanged.

    Raises:
        CoercionError: The type is not supported.
        EntityTypeError: The value cannot have this type.
    """
    if is_substitution(value):
        return normalize(value)
    if isinstance(value, str) or not isinstance(value, Iterable):
        return _checked(value, data_type)
    items = [normalize(item) if is_substitution(item) else item for item in value]
    plain = [item for item in items if not is_normalized_substitution(item)]
    _checked(plain, data_type)
    return items


def _checked(value: Any, data_type: Any) -> Any:
    if not is_instance_of(value, data_type):
        raise EntityTypeError("the value", type_name(data_type), value)
    return value


def perform_typed_substitution(
    context: LaunchContext, value: NormalizedValueType, data_type: Any = None
) -> Any:
    """Perform the substitutions in a value, convert their texts, and return the resulting value.

    Args:
        context: The launch.
        value: The result of `normalize_typed_substitution`.
        data_type: See `coerce_to_type`.

    Raises:
        CoercionError: The text of a substitution cannot be converted to this type.
        EntityTypeError: The value has another type.
    """
    if is_normalized_substitution(value):
        return coerce_to_type(perform(context, value), data_type)
    if not isinstance(value, list):
        return _checked(value, data_type)
    kind = None if data_type is None else extract_type(data_type)[0]
    found = [
        coerce_to_type(perform(context, item), kind) if is_normalized_substitution(item) else item
        for item in value
    ]
    if not is_instance_of(found, data_type):
        raise CoercionError(f"{found} is not a value of type {type_name(data_type)}")
    return found
