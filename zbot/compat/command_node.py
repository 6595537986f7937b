"""Node for programs that only read the graph, with the interface of ros2cli's `DirectNode`."""

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
    """Hidden node for a `with` block. It has all methods and attributes of a `Node`.

    The graph is complete as soon as the node exists. So ROS 2's daemon is not necessary.

    Args:
        args: Object that `argparse` returned. `init` gets the attribute `argv` of this object.
        node_name: Name of the node after the prefix `_ros2cli_`. The default is the process's pid.
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
        """This object itself, because zbot has no daemon."""
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
    """Add the shared options of `ros2` commands to a parser. The options have no effect."""
    parser.add_argument("--spin-time", type=float, help="Accepted; no effect")
    parser.add_argument("-s", "--use-sim-time", action="store_true", help="Accepted; no effect")
    parser.add_argument("--no-daemon", action="store_true", help="Accepted; no effect")
