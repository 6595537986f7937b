"""A node for programs that look at the graph and have none of their own: ros2cli's `DirectNode`."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from zbot import runtime

if TYPE_CHECKING:
    from argparse import ArgumentParser
    from types import TracebackType

    from typing_extensions import Self

    from zbot.node.node import Node

NODE_NAME_PREFIX = "_ros2cli"


class CommandNode:
    """A hidden node for a `with` block; it has all methods and attributes of a `Node`.

    The graph is complete when it is made, so it waits for nothing, and there is no daemon to ask.

    Args:
        args: What `argparse` made of a command line; only its `argv`, for `init`, is looked at.
        node_name: What follows the prefix of its name; the process's number if left out.
    """

    def __init__(self, args: Any = None, *, node_name: str | None = None) -> None:
        self._has_initialised = not runtime.ok()
        if self._has_initialised:
            runtime.init(args=getattr(args, "argv", []))
        self.node: Node = runtime.create_node(
            f"{NODE_NAME_PREFIX}_{node_name or os.getpid()}", start_parameter_services=False
        )

    @property
    def direct_node(self) -> Self:
        """The node itself: there is no daemon that could stand for it."""
        return self

    def __getattr__(self, name: str) -> Any:
        return getattr(self.node, name)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self.node.destroy_node()
        if self._has_initialised:
            runtime.try_shutdown()


def add_arguments(parser: ArgumentParser) -> None:
    """Give a parser the options that `ros2`'s commands have in common; none changes anything."""
    parser.add_argument("--spin-time", type=float, help="Accepted; there is nothing to wait for")
    parser.add_argument("-s", "--use-sim-time", action="store_true", help="Accepted")
    parser.add_argument("--no-daemon", action="store_true", help="Accepted; there is no daemon")
