# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `launch`: launch files."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch import (
    Action,
    Condition,
    Event,
    EventHandler,
    LaunchContext,
    LaunchDescription,
    LaunchDescriptionEntity,
    LaunchDescriptionSource,
    LaunchIntrospector,
    LaunchService,
    SomeSubstitutionsType,
    Substitution,
)
from zbot.launch.errors import InvalidLaunchFileError
from zbot.launch.event_handler import (
    Entities as SomeActionsType,
    Entities as SomeEntitiesType,
    Entities_types_tuple as SomeActionsType_types_tuple,
    Entities_types_tuple as SomeEntitiesType_types_tuple,
)
from zbot.launch.substitution import SomeSubstitutionsType_types_tuple

__all__ = [
    "Action",
    "Condition",
    "Event",
    "EventHandler",
    "InvalidLaunchFileError",
    "LaunchContext",
    "LaunchDescription",
    "LaunchDescriptionEntity",
    "LaunchDescriptionSource",
    "LaunchIntrospector",
    "LaunchService",
    "SomeActionsType",
    "SomeActionsType_types_tuple",
    "SomeEntitiesType",
    "SomeEntitiesType_types_tuple",
    "SomeSubstitutionsType",
    "SomeSubstitutionsType_types_tuple",
    "Substitution",
]

if TYPE_CHECKING:
    from . import action as action
    from . import actions as actions
    from . import condition as condition
    from . import conditions as conditions
    from . import descriptions as descriptions
    from . import event as event
    from . import event_handler as event_handler
    from . import event_handlers as event_handlers
    from . import events as events
    from . import frontend as frontend
    from . import invalid_launch_file_error as invalid_launch_file_error
    from . import launch_context as launch_context
    from . import launch_description as launch_description
    from . import launch_description_entity as launch_description_entity
    from . import launch_description_source as launch_description_source
    from . import launch_description_sources as launch_description_sources
    from . import launch_introspector as launch_introspector
    from . import launch_service as launch_service
    from . import logging as logging
    from . import some_actions_type as some_actions_type
    from . import some_entities_type as some_entities_type
    from . import some_substitutions_type as some_substitutions_type
    from . import substitution as substitution
    from . import substitutions as substitutions
    from . import utilities as utilities
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "action",
            "actions",
            "condition",
            "conditions",
            "descriptions",
            "event",
            "event_handler",
            "event_handlers",
            "events",
            "frontend",
            "invalid_launch_file_error",
            "launch_context",
            "launch_description",
            "launch_description_entity",
            "launch_description_source",
            "launch_description_sources",
            "launch_introspector",
            "launch_service",
            "logging",
            "some_actions_type",
            "some_entities_type",
            "some_substitutions_type",
            "substitution",
            "substitutions",
            "utilities",
        ),
    )[0]
