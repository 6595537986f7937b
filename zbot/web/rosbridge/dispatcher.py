"""Dispatcher of one client's messages to the operations that execute them."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING

from zbot.web.rosbridge.action_operations import ActionOperations
from zbot.web.rosbridge.client_message import Fragments, RosbridgeError, read_message
from zbot.web.rosbridge.service_operations import ServiceOperations
from zbot.web.rosbridge.session import UnknownHereError
from zbot.web.rosbridge.topic_operations import TopicOperations

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.web.rosbridge.client_message import ClientMessage
    from zbot.web.rosbridge.session import Session


class Dispatcher:
    """Dispatcher of one client's messages. Only one thread at a time may call `take` or `finish`.

    Args:
        session: The client's session.
    """

    def __init__(self, session: Session) -> None:
        self._session = session
        self._lock = threading.RLock()
        self._is_closed = False
        self._unfinished: str | bytes = ""
        self._fragments = Fragments()
        self._topics = TopicOperations(session)
        self._services = ServiceOperations(session)
        self._actions = ActionOperations(session)
        self._operations: dict[str, Callable[[ClientMessage], None]] = {
            "fragment": self._defragment,
            "set_level": session.set_level,
            "status_level": session.set_level,
            **self._topics.operations,
            **self._services.operations,
            **self._actions.operations,
        }

    def take(self, data: str | bytes) -> bool:
        """Execute a message of the client. If there is an error, send it as a status message.

        Returns:
            Whether the message is executed. If not, nodes must be asked for a type: call `finish`
            before the next message.
        """
        with self._lock:
            if not self._is_closed:
                self._carry_out(data)
            return not self._unfinished

    def finish(self) -> None:
        """Execute the message that `take` has not executed. This may take seconds."""
        with self._lock:
            data, self._unfinished = self._unfinished, ""
            self._session.may_ask = True
            self.take(data)
            self._session.may_ask = False

    def _carry_out(self, data: str | bytes) -> None:
        message: ClientMessage | None = None
        try:
            message = read_message(data)
            self._operation(message.op)(message)
        except UnknownHereError:
            self._unfinished = data
        except Exception as error:  # noqa: BLE001 - the other messages of the client go on
            self._session.report("error", self._session.bridge.sentence(error), message)

    def _operation(self, name: str) -> Callable[[ClientMessage], None]:
        operation = self._operations.get(name)
        if operation is None:
            known = ", ".join(sorted(self._operations))
            raise RosbridgeError(f"there is no operation {name!r}, but {known}")
        return operation

    def _defragment(self, message: ClientMessage) -> None:
        whole = self._fragments.add(message)
        if whole is not None:
            inner = read_message(whole)
            if inner.op == "fragment":
                raise RosbridgeError("a message in fragments cannot be a fragment")
            self.take(whole)

    def close(self) -> None:
        """Destroy everything that the client has created. Goals that it has sent continue."""
        with self._lock:
            self._is_closed = True
            self._topics.close()
            self._services.close()
            self._actions.close()
