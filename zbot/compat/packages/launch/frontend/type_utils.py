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
    is_instance_of_valid_type,
    is_typing_list,
    is_valid_scalar_type,
)

# Older versions of this module in ROS 2 have these names.
check_is_list = check_is_typing_list = is_typing_list
check_is_instance_of_valid_type = is_instance_of_valid_type
check_type = is_instance_of
check_valid_scalar_type = is_valid_scalar_type
