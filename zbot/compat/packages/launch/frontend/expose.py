# Written by python -m zbot.compat.generator; do not edit.
"""Decorators for a program's own tags and substitutions."""

from zbot.launch.frontend.registry import (
    expose as __expose_impl,
    expose_action,
    expose_substitution,
)

__all__ = [
    "expose_action",
    "expose_substitution",
]
