"""Thread that spins a node while other threads do other work."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING

from zbot.errors import ExternalShutdownException
from zbot.executor.single_threaded_executor import SingleThreadedExecutor
from zbot.threads.foreign_call import without_interruption

if TYPE_CHECKING:
    from collections.abc import Callable

    from typing_extensions import Self

    from zbot.executor.spinnable import SpinnableNode


class SpinThread:
    """Daemon thread that runs the callbacks of a node, until `stop` or the end of the context.

    The thread starts immediately. In a `with` block, the end of the block stops the thread.

    Args:
        node: The node.
        name: Name of the thread, for debuggers.
        on_error: Called in the thread with an exception of a callback. The thread then goes on. If
            left out, an exception ends the thread, and Python prints a traceback.

    Attributes:
        executor: The executor of the node.
        thread: The thread.
    """

    def __init__(
        self, node: SpinnableNode, name: str, on_error: Callable[[Exception], object] | None = None
    ) -> None:
        self._on_error = on_error
        self.executor = SingleThreadedExecutor(context=node.handle.context)
        self.executor.add_node(node)
        self.thread = threading.Thread(target=self._spin, name=name, daemon=True)
        without_interruption(self.thread.start)

    def _spin(self) -> None:
        while True:
            try:
                self.executor.spin()
            except (ExternalShutdownException, KeyboardInterrupt):
                return  # the main thread handles them too
            except Exception as error:
                if self._on_error is None:
                    raise
                self._on_error(error)
            else:
                return

    def stop(self, timeout_s: float | None = None) -> None:
        """Stop spinning, and remove the node from the executor. A second call is allowed.

        Args:
            timeout_s: How long to wait for the end of a running callback, and then for the end of
                the thread, in seconds. `None` means no limit.
        """
        self.executor.shutdown(timeout_s)
        self.join(timeout_s)

    def join(self, timeout_s: float | None = None) -> None:
        """Wait for the end of the thread. In a callback of the node, do not wait."""
        if self.thread is not threading.current_thread():
            self.thread.join(timeout_s)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *exc_info: object) -> None:
        self.stop()
