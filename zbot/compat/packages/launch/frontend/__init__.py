"""Launch files in XML and YAML."""

from zbot.launch.frontend.entity import Entity as Entity
from zbot.launch.frontend.errors import (
    InvalidFrontendLaunchFileError as InvalidFrontendLaunchFileError,
)
from zbot.launch.frontend.parser import Parser as Parser
from zbot.launch.frontend.registry import expose_action as expose_action
from zbot.launch.frontend.registry import expose_substitution as expose_substitution
