# Written by python -m zbot.compat.generator; do not edit.
"""Package of the module `cv_bridge_boost`."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names

if TYPE_CHECKING:
    from . import cv_bridge_boost as cv_bridge_boost
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "cv_bridge_boost",
        ),
    )[0]
