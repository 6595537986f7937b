# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `launch_xml`: launch files in XML."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.frontend.parser import Parser
from zbot.launch.frontend.xml_file import Entity

__all__ = [
    "Entity",
    "Parser",
]

if TYPE_CHECKING:
    from . import entity as entity
    from . import launch_description_sources as launch_description_sources
    from . import parser as parser
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "entity",
            "launch_description_sources",
            "parser",
        ),
    )[0]
