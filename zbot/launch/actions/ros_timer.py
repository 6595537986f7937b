"""Timer action that uses ROS time, which may be simulated."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING

from zbot.launch.actions.ros_names import PARAMETERS
from zbot.launch.actions.timer import TimerAction

if TYPE_CHECKING:
    from zbot.launch.context import LaunchContext

_INTERVAL_S = 0.02


class RosTimer(TimerAction):
    """Execute actions after a period of ROS time. See `TimerAction`.

    The time comes from `/clock` if `SetUseSimTime` or `SetParameter` sets `use_sim_time` to true.
    """

    _is_simulated = False

    def execute(self, context: LaunchContext) -> None:
        """Start the timer."""
        self._is_simulated = _is_simulated(context)
        super().execute(context)

    async def _sleep(self, seconds: float, context: LaunchContext) -> None:
        from zbot.launch.ros_node import launch_node  # noqa: PLC0415 - imports Zenoh
        from zbot.parameters.parameter import Parameter  # noqa: PLC0415 - few files need it

        node = launch_node(context).node
        # Check again, because actions that follow this timer in the launch file have run now.
        if self._is_simulated or _is_simulated(context):
            node.set_parameters([Parameter("use_sim_time", value=True)])
        clock = node.get_clock()
        end = clock.now().nanoseconds + int(seconds * 1e9)
        while clock.now().nanoseconds < end:
            await asyncio.sleep(min(_INTERVAL_S, seconds))


def _is_simulated(context: LaunchContext) -> bool:
    given = context.launch_configurations.get(PARAMETERS, ())
    pairs: dict[str, object] = dict(one for one in given if isinstance(one, tuple))
    return pairs.get("use_sim_time") is True


ROSTimer = RosTimer
