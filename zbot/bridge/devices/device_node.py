"""Node that stands for a device in the graph, and runs in a thread beside the device's own loop."""

from __future__ import annotations

import contextlib
import re
from typing import TYPE_CHECKING

from zbot.context import Context
from zbot.executor.spin_thread import SpinThread
from zbot.node.node import Node
from zbot.process.signals import SignalHandlerOptions, install

if TYPE_CHECKING:
    from collections.abc import Iterator

_NOT_IN_NAMES = re.compile(r"[^A-Za-z0-9_]+")


def node_name(kind: str, place: str) -> str:
    """Return the name of a node: `board` and `/dev/ttyACM0` give `board_ttyACM0`."""
    last = _NOT_IN_NAMES.sub("_", place.rpartition("/")[2]).strip("_")
    return f"{kind}_{last}" if last else kind


@contextlib.contextmanager
def device_node(name: str, namespace: str) -> Iterator[Node]:
    """Yield a node of a context of its own. A thread runs its callbacks.

    Ctrl-C raises `KeyboardInterrupt` in the main thread. SIGTERM makes `node.context.ok()` false.

    Args:
        name: The node's name.
        namespace: The node's namespace. It may be empty.
    """
    install(SignalHandlerOptions.ALL)
    context = Context()
    context.init([])
    try:
        with Node(name, context=context, namespace=namespace or None) as node:
            log = node.get_logger()
            with SpinThread(node, f"zbot {name}", lambda error: log.error(str(error))):
                yield node
    finally:
        context.shutdown()
