"""ROS 2's `launch`: launch files."""

from zbot.compat.submodules import submodules
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
from zbot.launch.event_handler import Entities as SomeActionsType
from zbot.launch.event_handler import Entities as SomeEntitiesType
from zbot.launch.substitution import SomeSubstitutionsType_types_tuple

__all__ = [
    "Action",
    "Condition",
    "Event",
    "EventHandler",
    "LaunchContext",
    "LaunchDescription",
    "LaunchDescriptionEntity",
    "LaunchDescriptionSource",
    "LaunchIntrospector",
    "LaunchService",
    "SomeActionsType",
    "SomeEntitiesType",
    "SomeSubstitutionsType",
    "SomeSubstitutionsType_types_tuple",
    "Substitution",
]

__getattr__ = submodules(
    __name__,
    "actions",
    "conditions",
    "descriptions",
    "event_handlers",
    "events",
    "frontend",
    "launch_description_sources",
    "logging",
    "substitutions",
    "utilities",
)
