"""The launch's own node: it hears of managed nodes, changes their states, and knows the time."""

from __future__ import annotations

import os
import threading
from typing import TYPE_CHECKING, Any

from zbot.context import Context
from zbot.errors import ExternalShutdownException
from zbot.executor import SingleThreadedExecutor
from zbot.node import Node

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.launch.context import LaunchContext

_KEY = "launch_node"
_SERVER_TIMEOUT_S = 20.0


class LaunchNode:
    """A node that spins in a thread of its own until the launch has ended."""

    def __init__(self) -> None:
        self._context = Context()
        self._context.init([])
        self.node = Node(f"launch_ros_{os.getpid()}", context=self._context, enable_rosout=False)
        self._executor = SingleThreadedExecutor(context=self._context)
        self._executor.add_node(self.node)
        self._thread = threading.Thread(target=self._spin, name="launch node")
        self._thread.start()

    def _spin(self) -> None:
        try:
            self._executor.spin()
        except ExternalShutdownException:
            return  # the launch ended

    def listen(self, topic: str, on_transition: Callable[[Any], None]) -> None:
        """Call a function with each `lifecycle_msgs/TransitionEvent` of a topic."""
        from lifecycle_msgs.msg import TransitionEvent  # noqa: PLC0415 - importable after zbot is

        self.node.create_subscription(TransitionEvent, topic, on_transition, 10)

    def change_state(
        self, node_name: str, transition: int, on_answer: Callable[[bool], None]
    ) -> None:
        """Ask a managed node for a transition; the function gets whether it was made."""
        # A node that was just started needs a moment to have its services.
        threading.Thread(
            target=self._change_state, args=(node_name, transition, on_answer), daemon=True
        ).start()

    def _change_state(
        self, node_name: str, transition: int, on_answer: Callable[[bool], None]
    ) -> None:
        from lifecycle_msgs.srv import ChangeState  # noqa: PLC0415 - as above

        client = self.node.create_client(ChangeState, f"{node_name}/change_state")
        request = ChangeState.Request()
        request.transition.id = transition
        if not client.wait_for_service(_SERVER_TIMEOUT_S):
            on_answer(False)
            return
        future = client.call_async(request)
        future.add_done_callback(lambda done: on_answer(_success(done)))

    def close(self) -> None:
        """Stop; the session is closed."""
        self._executor.shutdown(0)
        self._context.shutdown()
        self._thread.join()


def _success(future: Any) -> bool:
    return future.exception() is None and bool(future.result().success)


def launch_node(context: LaunchContext) -> LaunchNode:
    """Return the node of a launch, made when it is first needed."""
    node: LaunchNode | None = context.get_locals_as_dict().get(_KEY)
    if node is None:
        node = LaunchNode()
        context.extend_globals({_KEY: node})
        context.on_close(node.close)
        context.on_close(lambda: context.extend_globals({_KEY: None}))  # another run makes its own
    return node
