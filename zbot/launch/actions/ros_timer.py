"""Timers that follow the nodes' time, simulated or not."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING

from zbot.launch.actions.timer import TimerAction

if TYPE_CHECKING:
    from zbot.launch.context import LaunchContext

_INTERVAL_S = 0.02


class RosTimer(TimerAction):
    """Do several things after a while, measured by the clock of ROS; see `TimerAction`."""

    async def _sleep(self, seconds: float, context: LaunchContext) -> None:
        from zbot.launch.ros_node import launch_node  # noqa: PLC0415 - opens a session

        clock = launch_node(context).node.get_clock()
        end = clock.now().nanoseconds + int(seconds * 1e9)
        while clock.now().nanoseconds < end:
            await asyncio.sleep(min(_INTERVAL_S, seconds))


ROSTimer = RosTimer
