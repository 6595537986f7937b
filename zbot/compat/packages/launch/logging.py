# Written by python -m zbot.compat.generator; do not edit.
"""The log of a launch. A test that replaces a name here replaces it for every launch."""

from typing import TYPE_CHECKING

from zbot.compat.same_module import stand_for
from zbot.launch import log

if TYPE_CHECKING:
    from zbot.launch.log import *

stand_for(__name__, log)
