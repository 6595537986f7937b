"""Parameters of image_tools that choose the quality of service."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.qos import HistoryPolicy, QoSProfile, ReliabilityPolicy
from zbot_nodes.startup.program import ParameterError

if TYPE_CHECKING:
    import zbot

_RELIABILITY = {
    "reliable": ReliabilityPolicy.RELIABLE,
    "best_effort": ReliabilityPolicy.BEST_EFFORT,
}
_HISTORY = {"keep_last": HistoryPolicy.KEEP_LAST, "keep_all": HistoryPolicy.KEEP_ALL}


def declared_profile(node: zbot.Node) -> QoSProfile:
    """Declare `reliability`, `history` and `depth`, and return the profile.

    Raises:
        ParameterError: A value is not allowed.
    """
    reliability = str(node.declare_parameter("reliability", "reliable").value)
    history = str(node.declare_parameter("history", "keep_last").value)
    depth = int(node.declare_parameter("depth", 10).value)
    if reliability not in _RELIABILITY:
        raise ParameterError(f"reliability must be reliable or best_effort, not '{reliability}'")
    if history not in _HISTORY or depth < 1:
        raise ParameterError("history must be keep_last or keep_all, and depth at least 1")
    return QoSProfile(depth=depth, history=_HISTORY[history], reliability=_RELIABILITY[reliability])
