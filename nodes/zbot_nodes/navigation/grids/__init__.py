"""Grids, scans, poses and paths of navigation, without a node. They need numpy.

The nodes import numpy from here, so a program without numpy ends with one sentence.
"""

from zbot.errors import require_numpy

require_numpy("navigation")

import numpy as np  # noqa: E402 - after the check

__all__ = ["np"]
