"""Timer action, which executes other actions after a period."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any

from zbot.launch.action import Action
from zbot.launch.actions.ros_names import PARAMETERS
from zbot.launch.entity import entity_list
from zbot.launch.errors import EntityTypeError
from zbot.launch.event import TimerEvent
from zbot.launch.event_handler import EventHandler, OnShutdown
from zbot.launch.substitution import normalize, perform

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from zbot.launch.context import LaunchContext
    from zbot.launch.entity import LaunchDescriptionEntity
    from zbot.launch.substitution import SomeSubstitutionsType

_INTERVAL_S = 0.02


class TimerAction(Action):
    """Execute actions after a period.

    Args:
        period: Seconds to wait.
        actions: The actions.
        cancel_on_shutdown: Whether the shutdown of the launch cancels the timer.
    """

    def __init__(
        self,
        *,
        period: float | SomeSubstitutionsType,
        actions: Iterable[LaunchDescriptionEntity],
        cancel_on_shutdown: bool = True,
        **options: Any,
    ) -> None:
        super().__init__(**options)
        self.period: Any = period if isinstance(period, (int, float)) else normalize(period)
        self.actions = entity_list("TimerAction", actions)
        self.cancel_on_shutdown = cancel_on_shutdown
        self._done: asyncio.Future[None] | None = None
        self._task: asyncio.Task[Any] | None = None

    def execute(self, context: LaunchContext) -> None:
        """Start the timer."""
        seconds = _seconds(self.period, context)
        self._done = context.running_loop.create_future()
        context.add_completion_future(self._done)
        context.register_event_handler(
            EventHandler(
                matcher=lambda event: isinstance(event, TimerEvent) and event.timer_action is self,
                entities=self._finish,
                handle_once=True,
            )
        )
        if self.cancel_on_shutdown:
            context.register_event_handler(OnShutdown(on_shutdown=lambda *_: self.cancel()))
        self._task = context.running_loop.create_task(self._wait(seconds, context))

    async def _wait(self, seconds: float, context: LaunchContext) -> None:
        await self._sleep(seconds, context)
        context.emit_event_sync(TimerEvent(timer_action=self))

    async def _sleep(self, seconds: float, context: LaunchContext) -> None:  # noqa: ARG002 - RosTimer
        await asyncio.sleep(seconds)

    def _finish(self, event: TimerEvent, context: LaunchContext) -> Sequence[Any]:  # noqa: ARG002
        self._complete()
        return self.actions

    def cancel(self) -> None:
        """Stop the timer without executing its actions."""
        if self._task is not None:
            self._task.cancel()
        self._complete()

    def _complete(self) -> None:
        if self._done is not None and not self._done.done():
            self._done.set_result(None)

    def get_asyncio_future(self) -> asyncio.Future[None] | None:
        """Return a future that is done when the period is over or the timer is cancelled."""
        return self._done

    def describe(self) -> str:
        """Return the name of the class."""
        return f"{type(self).__name__}()"

    def describe_conditional_sub_entities(
        self,
    ) -> list[tuple[str, Sequence[LaunchDescriptionEntity]]]:
        """Return the actions."""
        return [("after some time", self.actions)]


def _seconds(period: Any, context: LaunchContext) -> float:
    text = str(period) if isinstance(period, (int, float)) else perform(context, period)
    try:
        return max(0.0, float(text))
    except ValueError:
        raise EntityTypeError("period", "a number of seconds", text) from None


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
    pairs: dict[str, object] = dict(pair for pair in given if isinstance(pair, tuple))
    return pairs.get("use_sim_time") is True


ROSTimer = RosTimer
