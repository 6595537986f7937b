"""Actions and services of other nodes, awaited by a coroutine."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import zbot
from zbot.action import ActionClient

from action_msgs.msg import GoalStatus

if TYPE_CHECKING:
    from zbot_nodes.navigation.managed_server import ManagedServer


class RemoteError(Exception):
    """Another node did not do what it was asked for.

    Args:
        code: The error code of its action, or 0.
        text: What is wrong.
    """

    def __init__(self, code: int, text: str) -> None:
        self.code = code
        super().__init__(text)


class RunningGoal(NamedTuple):
    """Goal that another node has accepted."""

    handle: Any
    future: Any  #: of its response

    @property
    def is_over(self) -> bool:
        """Whether it has ended."""
        return bool(self.future.done())

    def result(self) -> Any:
        """Return the result of a goal that has ended.

        Raises:
            RemoteError: The goal was not reached.
        """
        error = self.future.exception()
        if error is not None:
            raise RemoteError(0, str(error))
        response = self.future.result()
        if response.status != GoalStatus.STATUS_SUCCEEDED:
            result = response.result
            raise RemoteError(result.error_code, result.error_msg or "the goal was not reached")
        return response.result


class RemoteActions:
    """Clients of the actions of other nodes.

    Args:
        node: The node that asks.
        kinds: The actions and their types.
    """

    def __init__(self, node: ManagedServer, kinds: dict[str, type[Any]]) -> None:
        self._node = node
        self._clients = {
            name: ActionClient[Any, Any, Any](node, kind, name, callback_group=node.group)
            for name, kind in kinds.items()
        }

    async def start(self, name: str, goal: Any) -> RunningGoal:
        """Send a goal.

        Raises:
            RemoteError: The server is not there, or does not accept the goal.
        """
        client = self._clients[name]
        if not client.server_is_ready():
            raise RemoteError(0, f"no node has the action {name}")
        try:
            handle = await client.send_goal_async(goal)
        except zbot.ZbotError as error:
            raise RemoteError(0, str(error)) from error
        if handle is None or not handle.accepted:
            raise RemoteError(0, f"the action {name} does not accept goals: is its node active?")
        return RunningGoal(handle, handle.get_result_async())

    async def run(self, name: str, goal: Any) -> Any:
        """Send a goal, and wait for its result.

        Raises:
            RemoteError: The goal was not reached.
        """
        running = await self.start(name, goal)
        try:
            await running.future
        except zbot.ZbotError as error:
            raise RemoteError(0, str(error)) from error
        return running.result()

    def close(self) -> None:
        """Destroy the clients."""
        for client in self._clients.values():
            client.destroy()


async def cancel(running: RunningGoal | None) -> None:
    """Cancel a goal, if it still runs."""
    if running is not None and not running.is_over:
        try:
            await running.handle.cancel_goal_async()
        except zbot.ZbotError:
            return  # its server has ended
