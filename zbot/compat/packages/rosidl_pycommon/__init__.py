# Written by python -m zbot.compat.generator; do not edit.
"""The common base classes of interface classes under ROS 2's name."""

from typing import TYPE_CHECKING

from zbot.compat.first_use import at_first_use

if TYPE_CHECKING:
    from . import interface_base_classes as interface_base_classes
else:
    __getattr__ = at_first_use(
        __name__,
        "interface_base_classes",
    )
