# Written by python -m zbot.compat.generator; do not edit.
"""Numbers."""

from zbot.time import S_TO_NS

__all__ = [
    "S_TO_NS",
]
