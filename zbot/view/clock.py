"""Clock of the view: the machine's time, or that of `/clock` while a node publishes it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.parameters.parameter import Parameter
from zbot.tf2.diagnosis.surroundings import CLOCK_TOPIC

if TYPE_CHECKING:
    from zbot.node.node import Node
    from zbot.view.source import Graph

_USE_SIM_TIME = "use_sim_time"
_BACK_NS = 10**9  #: the time of a simulator jumps back by more than this when it begins again


class ViewClock:
    """Clock of the view. Only one thread may use it.

    Args:
        node: The node whose clock it is.
        is_automatic: Whether `use_sim_time` of the node is set as long as a node publishes
            `/clock`. Otherwise the parameter of the node decides.
    """

    def __init__(self, node: Node, *, is_automatic: bool) -> None:
        self._node, self._is_automatic = node, is_automatic
        self._is_simulated = False
        self._last_ns = 0

    def look(self, graph: Graph) -> None:
        """Look for publishers of `/clock`."""
        is_simulated = bool(graph.publishers(CLOCK_TOPIC))
        if self._is_automatic and is_simulated != self._is_simulated:
            self._is_simulated = is_simulated
            self._node.set_parameters([Parameter(_USE_SIM_TIME, value=is_simulated)])
            self._last_ns = 0

    def now_ns(self) -> int:
        """Return the time in nanoseconds since the epoch. A simulated time begins at 0."""
        return int(self._node.get_clock().now().nanoseconds)

    def has_jumped_back(self) -> bool:
        """Return whether the time has begun again since the last call."""
        last_ns, self._last_ns = self._last_ns, self.now_ns()
        return self._last_ns < last_ns - _BACK_NS
