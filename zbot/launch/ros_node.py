"""Node that the launch itself uses for the states of managed nodes and for simulated time."""

from __future__ import annotations

import os
import threading
from typing import TYPE_CHECKING, Any

from zbot.context import Context
from zbot.errors import ExternalShutdownException, ZbotError
from zbot.executor.spin_thread import SpinThread
from zbot.node.node import Node

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.executor.single_threaded_executor import SingleThreadedExecutor
    from zbot.launch.context import LaunchContext

_KEY = "launch_node"
_SERVER_TIMEOUT_S = 20.0


class LaunchNode:
    """A node that spins in its own thread until it is shut down.

    Attributes:
        ros_context: The context of the node.
        ros_executor: The executor that spins the node.
    """

    ros_context: Context
    ros_executor: SingleThreadedExecutor

    def __init__(self) -> None:
        self._node: Node | None = None
        self.start()

    def start(self) -> None:
        """Create the node and spin it, unless the node exists already."""
        if self._node is not None:
            return
        self.ros_context = Context()
        self.ros_context.init([])
        self._node = Node(
            f"launch_ros_{os.getpid()}", context=self.ros_context, enable_rosout=False
        )
        self._spinner = SpinThread(self._node, "launch node")
        self.ros_executor = self._spinner.executor

    @property
    def ros_node(self) -> Node | None:
        """The node, or None after the shutdown."""
        return self._node

    @property
    def node(self) -> Node:
        """The node.

        Raises:
            ExternalShutdownException: The node was shut down.
        """
        if self._node is None:
            raise ExternalShutdownException
        return self._node

    def listen(self, topic: str, on_transition: Callable[[Any], None]) -> None:
        """Call a function with each `lifecycle_msgs/TransitionEvent` on a topic."""
        from lifecycle_msgs.msg import TransitionEvent  # noqa: PLC0415 - the import makes the class

        self.node.create_subscription(TransitionEvent, topic, on_transition, 10)

    def change_state(
        self, node_name: str, transition: int, on_answer: Callable[[bool], None]
    ) -> None:
        """Request a transition of a managed node. `on_answer` gets True if the node succeeded."""
        # A thread sends the request, because it first waits for the service of the node. A node
        # that has just started has no services yet.
        threading.Thread(
            target=self._change_state, args=(node_name, transition, on_answer), daemon=True
        ).start()

    def _change_state(
        self, node_name: str, transition: int, on_answer: Callable[[bool], None]
    ) -> None:
        from zbot.remote.managed_nodes import ManagedNodes  # noqa: PLC0415 - makes message classes

        managed = ManagedNodes(self.node, server_timeout_s=_SERVER_TIMEOUT_S)
        try:
            succeeded = managed.request(node_name, transition)
        except ZbotError:
            if self._node is None:
                return  # the launch ended
            succeeded = False
        on_answer(succeeded)

    def shutdown(self) -> None:
        """Stop the spinning and close the session. A second call does nothing."""
        if self._node is None:
            return
        self._node = None
        self._spinner.stop(0)
        self.ros_context.shutdown()
        self._spinner.join()


def launch_node(context: LaunchContext) -> LaunchNode:
    """Return the node of a launch. The first call creates it."""
    node: LaunchNode | None = context.get_locals_as_dict().get(_KEY)
    if node is None:
        node = LaunchNode()
        context.extend_globals({_KEY: node})
        context.on_close(node.shutdown)
        context.on_close(
            lambda: context.extend_globals({_KEY: None})
        )  # a second run creates a new node
    return node


def get_ros_node(context: LaunchContext) -> Node:
    """Return the `Node` of a launch. See `launch_node`."""
    return launch_node(context).node
