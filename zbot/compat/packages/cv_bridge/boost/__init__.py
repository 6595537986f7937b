# Written by python -m zbot.compat.generator; do not edit.
"""Package of the module `cv_bridge_boost`."""

from typing import TYPE_CHECKING

from zbot.compat.first_use import at_first_use

if TYPE_CHECKING:
    from . import cv_bridge_boost as cv_bridge_boost
else:
    __getattr__ = at_first_use(
        __name__,
        "cv_bridge_boost",
    )
