# Written by python -m zbot.compat.generator; do not edit.
"""The common base classes of interface classes under ROS 2's name."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names

if TYPE_CHECKING:
    from . import interface_base_classes as interface_base_classes
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "interface_base_classes",
        ),
    )[0]
