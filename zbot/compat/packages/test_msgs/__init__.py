# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `test_msgs`: types for tests. zbot makes `msg`, `srv` and `action` at their import."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names

if TYPE_CHECKING:
    from . import message_fixtures as message_fixtures
    from . import service_fixtures as service_fixtures
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "message_fixtures",
            "service_fixtures",
        ),
    )[0]
