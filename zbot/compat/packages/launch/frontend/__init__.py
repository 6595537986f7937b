# Written by python -m zbot.compat.generator; do not edit.
"""Launch files in XML and YAML."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.frontend.entity import Entity
from zbot.launch.errors import InvalidFrontendLaunchFileError
from zbot.launch.frontend.parser import Parser
from zbot.launch.frontend.registry import expose_action, expose_substitution

__all__ = [
    "Entity",
    "InvalidFrontendLaunchFileError",
    "Parser",
    "expose_action",
    "expose_substitution",
]

if TYPE_CHECKING:
    from . import entity as entity
    from . import expose as expose
    from . import parse_substitution as parse_substitution
    from . import parser as parser
    from . import type_utils as type_utils
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "entity",
            "expose",
            "parse_substitution",
            "parser",
            "type_utils",
        ),
    )[0]
