# Written by python -m zbot.compat.generator; do not edit.
"""Launch descriptions that spawn controllers."""

from zbot.launch.actions.controller_spawner import (
    generate_controllers_spawner_launch_description,
    generate_controllers_spawner_launch_description_from_dict,
    generate_load_controller_launch_description,
    generate_spawner_launch_description,
)

__all__ = [
    "generate_controllers_spawner_launch_description",
    "generate_controllers_spawner_launch_description_from_dict",
    "generate_load_controller_launch_description",
    "generate_spawner_launch_description",
]
