"""Values of launch files that must have a type: `launch.utilities.type_utils`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeAlias, get_args, get_origin

import yaml

from zbot.launch.errors import EntityTypeError
from zbot.launch.substitution import is_a_substitution, normalize, perform

if TYPE_CHECKING:
    from zbot.launch.context import LaunchContext

#: A text, a number, a truth value or a list of one kind, all of them perhaps as substitutions.
SomeValueType: TypeAlias = Any
NormalizedValueType: TypeAlias = Any
AllowedTypesType: TypeAlias = Any


def coerce_to_type(value: str, data_type: Any = None, can_be_str: bool = True) -> Any:
    """Return what a text means as YAML.

    Args:
        value: The text.
        data_type: `bool`, `int`, `float`, `str` or a list of one, as in `List[int]`; any if `None`.
        can_be_str: Whether the text itself is a value where YAML finds no other.

    Raises:
        EntityTypeError: The text has another type.
    """
    if data_type is str:
        return value
    try:
        found = yaml.safe_load(value)
    except yaml.YAMLError:
        found = value
    if data_type is float and type(found) is int:
        return float(found)
    fits = can_be_str or not isinstance(found, str) if data_type is None else _is(found, data_type)
    if not fits:
        raise EntityTypeError("the value", _said(data_type), value)
    return value if data_type is None and isinstance(found, str) else found


def _is(value: Any, data_type: Any) -> bool:
    if get_origin(data_type) is list or data_type is list:
        (inner,) = get_args(data_type) or (None,)
        return isinstance(value, list) and (inner is None or all(_is(one, inner) for one in value))
    return type(value) is data_type


def _said(data_type: Any) -> str:
    return getattr(data_type, "__name__", "no text") if data_type is not None else "no text"


def normalize_typed_substitution(value: SomeValueType, data_type: Any = None) -> Any:
    """Return a value in which texts to be are lists of substitutions; others stay as they are."""
    del data_type  # it is looked at when the value is performed: until then it may be anything
    if isinstance(value, str) or is_a_substitution(value):
        return normalize(value)
    return value


def perform_typed_substitution(
    context: LaunchContext, value: NormalizedValueType, data_type: Any = None
) -> Any:
    """Return a value in which substitutions have become what they stand for.

    Args:
        context: The launch.
        value: What `normalize_typed_substitution` returned.
        data_type: See `coerce_to_type`.

    Raises:
        EntityTypeError: It has another type.
    """
    if isinstance(value, (list, tuple)) and value and all(map(is_a_substitution, value)):
        return coerce_to_type(perform(context, value), data_type)
    if isinstance(value, (list, tuple)):
        (inner,) = get_args(data_type) or (None,)
        return [perform_typed_substitution(context, one, inner) for one in value]
    if is_a_substitution(value):
        return coerce_to_type(perform(context, value), data_type)
    if data_type is not None and not _is(value, data_type):
        raise EntityTypeError("the value", _said(data_type), value)
    return value
