# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `launch_ros`: nodes in launch files."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names

if TYPE_CHECKING:
    from . import actions as actions
    from . import descriptions as descriptions
    from . import event_handlers as event_handlers
    from . import events as events
    from . import parameter_descriptions as parameter_descriptions
    from . import parameters_type as parameters_type
    from . import ros_adapters as ros_adapters
    from . import substitutions as substitutions
    from . import utilities as utilities
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "actions",
            "descriptions",
            "event_handlers",
            "events",
            "parameter_descriptions",
            "parameters_type",
            "ros_adapters",
            "substitutions",
            "utilities",
        ),
    )[0]
