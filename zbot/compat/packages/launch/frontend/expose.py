"""Decorators for a program's own tags and substitutions."""

from zbot.launch.frontend.registry import expose as __expose_impl
from zbot.launch.frontend.registry import expose_action, expose_substitution
