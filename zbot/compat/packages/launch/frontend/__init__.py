"""Launch files in XML and YAML."""

from zbot.compat.submodules import submodules
from zbot.launch.frontend.entity import Entity
from zbot.launch.frontend.errors import (
    InvalidFrontendLaunchFileError,
)
from zbot.launch.frontend.parser import Parser
from zbot.launch.frontend.registry import expose_action, expose_substitution

__getattr__ = submodules(__name__, "entity", "expose", "parse_substitution", "parser", "type_utils")
