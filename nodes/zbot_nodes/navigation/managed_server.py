"""Base of the managed nodes of navigation: their parameters, frames and actions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import zbot
from zbot.action import ActionServer, CancelResponse, GoalResponse
from zbot.lifecycle import LifecycleNode, TransitionCallbackReturn
from zbot_nodes.navigation.robot_frames import RobotFrames
from zbot_nodes.navigation.settings import Settings
from zbot_nodes.startup.program import ParameterError

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.lifecycle import LifecycleState


class Ticker:
    """Timer that a coroutine awaits, once for each period of its loop.

    Args:
        node: The node whose clock counts.
        period_s: The period.
    """

    def __init__(self, node: zbot.Node, period_s: float) -> None:
        self._node = node
        self._next: zbot.Future[bool] = zbot.Future()
        self._timer = node.create_timer(
            period_s, self._tick, callback_group=zbot.ReentrantCallbackGroup()
        )

    async def next(self) -> None:
        """Wait for the next tick."""
        await self._next

    def close(self) -> None:
        """End the timer."""
        self._node.destroy_timer(self._timer)

    def _tick(self) -> None:
        ended, self._next = self._next, zbot.Future()
        ended.set_result(True)


class ManagedServer(LifecycleNode):
    """Managed node with actions. A new goal of an action ends the goal before it.

    Args:
        name: The name of the node.
        options: The options of `zbot.Node`.
    """

    def __init__(self, name: str, **options: Any) -> None:
        super().__init__(name, **options)
        self.settings = Settings(self)
        self.frames = RobotFrames(self)
        self.is_active = False
        self.group = zbot.ReentrantCallbackGroup()  # for callbacks that wait
        self._newest: dict[str, Any] = {}  #: the last goal of each action
        self._actions: list[ActionServer[Any, Any, Any]] = []

    def configure(self) -> None:
        """Read the parameters, and create topics, services and actions.

        Raises:
            ParameterError: A parameter cannot be used.
        """

    def activate(self) -> None:
        """Begin to work."""

    def deactivate(self) -> None:
        """Stop to work."""

    def clean_up(self) -> None:
        """Destroy what `configure` made."""

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Read the parameters, and name those without effect."""
        self.get_logger().info("Configuring")
        try:
            self.configure()
        except ParameterError as error:
            self.get_logger().error(str(error))
            return TransitionCallbackReturn.FAILURE
        self.settings.name_unused()
        return super().on_configure(state)

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Begin to work."""
        self.get_logger().info("Activating")
        result = super().on_activate(state)
        self.is_active = True
        self.activate()
        return result

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """End all goals."""
        self.get_logger().info("Deactivating")
        self.is_active = False
        self.deactivate()
        return super().on_deactivate(state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Destroy the actions and what else `configure` made."""
        self.get_logger().info("Cleaning up")
        for server in self._actions:
            server.destroy()
        self._actions.clear()
        self.clean_up()
        return super().on_cleanup(state)

    def create_action(self, kind: type[Any], name: str, execute: Callable[[Any], Any]) -> None:
        """Create an action. While the node is not active, it rejects goals."""

        def decide(_goal: Any) -> GoalResponse:
            return GoalResponse.ACCEPT if self.is_active else GoalResponse.REJECT

        def accept(handle: Any) -> None:
            self._newest[name] = handle
            handle.execute()

        self._actions.append(
            ActionServer(
                self,
                kind,
                name,
                execute,
                callback_group=self.group,
                goal_callback=decide,
                handle_accepted_callback=accept,
                cancel_callback=lambda _handle: CancelResponse.ACCEPT,
            )
        )

    def is_wanted(self, name: str, handle: Any) -> bool:
        """Return whether a goal of an action is still to be reached."""
        return self.is_active and self.is_newest(name, handle) and not handle.is_cancel_requested

    def is_newest(self, name: str, handle: Any) -> bool:
        """Return whether no other goal of this action came later."""
        return self._newest.get(name) is handle

    def seconds(self) -> float:
        """Return the time of the node's clock."""
        return self.get_clock().now().nanoseconds / 1e9

    def stamp(self) -> Any:
        """Return the time of the node's clock as a message."""
        return self.get_clock().now().to_msg()


def end_goal(handle: Any, result: Any, code: int = 0, text: str = "") -> Any:
    """End a goal, and return its result: canceled if this was asked for, or an error if it has one.

    Args:
        handle: The goal.
        result: Its result.
        code: An error code of the action. 0 means that the goal was reached.
        text: What went wrong.
    """
    result.error_code, result.error_msg = code, text
    if handle.is_cancel_requested:
        handle.canceled()
    elif code:
        handle.abort()
    else:
        handle.succeed()
    return result
