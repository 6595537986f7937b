"""Thread that runs the callbacks of a node, while another thread records or plays."""

from __future__ import annotations

import contextlib
import threading
from typing import TYPE_CHECKING

from zbot.errors import ExternalShutdownException
from zbot.executor.single_threaded_executor import SingleThreadedExecutor

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.node.node import Node


@contextlib.contextmanager
def spinning(node: Node) -> Iterator[None]:
    """Run the callbacks of a node in a thread, until the end of the `with` block."""
    executor = SingleThreadedExecutor(context=node.context)
    executor.add_node(node)

    def spin() -> None:
        # The thread that plays or records handles these exceptions.
        with contextlib.suppress(ExternalShutdownException, KeyboardInterrupt):
            executor.spin()

    thread = threading.Thread(target=spin, name="zbot bag services", daemon=True)
    thread.start()
    try:
        yield
    finally:
        executor.shutdown()
        thread.join()
