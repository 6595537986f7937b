# Written by python -m zbot.compat.generator; do not edit.
"""Type of arguments that are paths."""

from zbot.compat.launch_utilities import FilePath

__all__ = [
    "FilePath",
]
