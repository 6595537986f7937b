# Written by python -m zbot.compat.generator; do not edit.
"""Nav2's `nav2_common`."""

from typing import TYPE_CHECKING

from zbot.compat.first_use import at_first_use

if TYPE_CHECKING:
    from . import launch as launch
else:
    __getattr__ = at_first_use(
        __name__,
        "launch",
    )
