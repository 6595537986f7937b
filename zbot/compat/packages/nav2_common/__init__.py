# Written by python -m zbot.compat.generator; do not edit.
"""Nav2's `nav2_common`."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names

if TYPE_CHECKING:
    from . import launch as launch
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "launch",
        ),
    )[0]
