# Written by python -m zbot.compat.generator; do not edit.
"""Functions for the types of attributes, which readers of launch files use."""

from zbot.launch.frontend.entity import Entity, check_is_list_entity
from zbot.launch.typed_value import (
    AllowedTypesType,
    coerce_list,
    coerce_to_type,
    extract_type,
    get_data_type_from_identifier,
    get_typed_value,
    is_instance_of,
    is_instance_of as check_type,
    is_instance_of_valid_type,
    is_instance_of_valid_type as check_is_instance_of_valid_type,
    is_typing_list,
    is_typing_list as check_is_list,
    is_typing_list as check_is_typing_list,
    is_valid_scalar_type,
    is_valid_scalar_type as check_valid_scalar_type,
)

__all__ = [
    "AllowedTypesType",
    "Entity",
    "check_is_instance_of_valid_type",
    "check_is_list",
    "check_is_list_entity",
    "check_is_typing_list",
    "check_type",
    "check_valid_scalar_type",
    "coerce_list",
    "coerce_to_type",
    "extract_type",
    "get_data_type_from_identifier",
    "get_typed_value",
    "is_instance_of",
    "is_instance_of_valid_type",
    "is_typing_list",
    "is_valid_scalar_type",
]
