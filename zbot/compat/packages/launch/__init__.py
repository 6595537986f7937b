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
from zbot.launch.errors import InvalidLaunchFileError
from zbot.launch.event_handler import Entities as SomeActionsType
from zbot.launch.event_handler import Entities as SomeEntitiesType
from zbot.launch.event_handler import Entities_types_tuple as SomeActionsType_types_tuple
from zbot.launch.event_handler import Entities_types_tuple as SomeEntitiesType_types_tuple
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
