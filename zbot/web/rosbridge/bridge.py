"""Node and executor that all clients of rosbridge share."""

from __future__ import annotations

import traceback
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.executor.spin_thread import SpinThread
from zbot.log import get_logger
from zbot.memory import give_back_freed_memory
from zbot.node.node import Node
from zbot.observer.serving.client_budget import Clients
from zbot.observer.shared_entities import SharedEntities
from zbot.web.rosbridge.client_message import RosbridgeError

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.graph.snapshot import Snapshot
    from zbot.observer.system import System

NODE_NAME = "rosbridge_websocket"
_END_S = 2.0  #: longest wait for a callback at the end
_THREADS = 16


class ClientFailedError(ZbotError):
    """A client did not answer a request correctly. The caller gets the text of this error."""


class Bridge:
    """Node and executor of all clients.

    Any thread may call the methods.

    Args:
        system: The running system. The node ends with the context of the system.

    Attributes:
        node: The node that publishes, subscribes, calls and serves for the clients.
        shared: Publishers, service clients and action clients that all rosbridge clients share.
        threads: Threads that handle messages of clients and encode messages for clients.
        waiting_threads: Threads that wait for answers of nodes, e.g. for parameters or types. A
            node that does not answer delays only these threads.
        is_read_only: Whether clients can only read.
        clients: The clients. Only the thread of the server may use them.
    """

    def __init__(self, system: System) -> None:
        self.system = system
        self.is_read_only = system.read_only
        self.shared = SharedEntities()
        self.clients = Clients()
        self.threads = ThreadPoolExecutor(_THREADS, "zbot rosbridge")
        self.waiting_threads = ThreadPoolExecutor(_THREADS, "zbot rosapi")
        self.node = Node(
            NODE_NAME,
            context=system.context,
            use_global_arguments=False,
            enable_rosout=False,
            start_parameter_services=False,
        )
        self._spinner = SpinThread(self.node, "zbot rosbridge", self._on_error)

    def _on_error(self, error: Exception) -> None:
        if not isinstance(error, ClientFailedError):  # its caller has received the error
            self.report(error)

    @staticmethod
    def report(error: Exception) -> None:
        """Log an error of the server itself, with its traceback."""
        get_logger("zbot.web").error("".join(traceback.format_exception(error)))

    def sentence(self, error: Exception) -> str:
        """Return the text of an error for a client. Log an error of the server itself."""
        if isinstance(error, ZbotError):
            return str(error)
        self.report(error)
        return f"the server failed: {error!r}"

    def close(self) -> None:
        """Stop the callbacks, and cancel all work that has not begun. The context ends the node."""
        self._spinner.stop(_END_S)
        for threads in (self.threads, self.waiting_threads):
            threads.shutdown(wait=False, cancel_futures=True)

    def end_client(self, close: Callable[[], None]) -> None:
        """Destroy in another thread what a client has created."""
        if self.node.context.ok():
            # The client's last message may still wait for an answer, and `close` waits for it.
            self.waiting_threads.submit(self._run, close)

    def _run(self, close: Callable[[], None]) -> None:
        try:
            close()
        except Exception as error:  # noqa: BLE001 - nobody else would see it in this thread
            self.report(error)
        give_back_freed_memory()

    def graph(self) -> Snapshot:
        """Return the graph as it is now."""
        return self.system.snapshot()

    def now(self) -> Any:
        """Return the current time as a message."""
        return self.node.get_clock().now().to_msg()

    def interface(self, kind: str, name: str) -> Any:
        """Return the class of a type. This may take seconds. See `Session.interface`.

        Args:
            kind: `msg`, `srv` or `action`.
            name: The name, e.g. `std_msgs/msg/String`, or as in ROS 1 `std_msgs/String`.

        Raises:
            RosbridgeError: The name is not the name of a type of this kind.
            UnknownTypeError: No definition of the type was found.
        """
        return self.system.interface(full_type(kind, name))


def full_type(kind: str, name: str) -> str:
    """Return the full name of a type. See `Bridge.interface`.

    Raises:
        RosbridgeError: The name is not the name of a type of this kind.
    """
    parts = name.split("/")
    if len(parts) == 2:
        parts.insert(1, kind)
    is_name = len(parts) == 3 and parts[1] == kind and all(map(_is_word, parts))
    if not is_name:
        example = {"msg": "std_msgs/msg/String", "srv": "std_srvs/srv/SetBool"}
        shown = example.get(kind, "example_interfaces/action/Fibonacci")
        raise RosbridgeError(
            f"{name!r} is not the name of a type of the kind {kind}: write e.g. {shown}"
        )
    return "/".join(parts)


def _is_word(text: str) -> bool:
    return text.isascii() and text.isidentifier()
