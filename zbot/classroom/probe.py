"""Why nothing answers: a look at a TCP port, before Zenoh gives its one answer to all of it."""

from __future__ import annotations

import errno
import queue
import socket
import threading
import time
from typing import TYPE_CHECKING

from zbot.classroom.errors import (
    AddressError,
    BlockedPortError,
    ClassroomError,
    ClosedPortError,
    DeadHostError,
)

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.classroom.address import Address

#: A connection in one building takes milliseconds; after a lost packet it is tried again at 1 s.
_TIMEOUT_S = 1.25
_LOOK_UP_S = 0.3
_PAUSE_S = 0.05  # between attempts where the port is refused
# Ports that hardly any machine leaves unanswered: a refusal there shows that it is on.
_SIGN_OF_LIFE_PORTS = (22, 80, 135, 445, 5000, 7)
_REFUSED = {errno.ECONNREFUSED, getattr(errno, "WSAECONNREFUSED", errno.ECONNREFUSED)}


def first_that_answers(candidates: Sequence[Address], timeout_s: float = _TIMEOUT_S) -> Address:
    """Return the first of some addresses that accepts a TCP connection; all are tried at once.

    Raises:
        DeadHostError: Nobody is at the (most promising) address.
        BlockedPortError: A machine is, and something swallows what is sent to its port.
        ClosedPortError: A machine is, and no program listens.
        AddressError: The name is unknown.
    """
    answers: queue.SimpleQueue[tuple[Address, ClassroomError | None]] = queue.SimpleQueue()

    def look(address: Address) -> None:
        answers.put((address, problem_at(address, timeout_s)))

    for candidate in candidates:
        threading.Thread(target=look, args=(candidate,), daemon=True).start()
    problems: list[ClassroomError] = []
    for candidate in candidates:
        try:
            # Looking a name up may take longer than connecting, and cannot be told to hurry.
            address, problem = answers.get(timeout=timeout_s + _LOOK_UP_S)
        except queue.Empty:
            raise AddressError(candidate.host, "no name server answers: use the number") from None
        if problem is None:
            return address
        problems.append(problem)
    raise min(problems, key=_distance)


def _distance(problem: ClassroomError) -> int:
    """Order problems by how near they are to an open class."""
    order = (ClosedPortError, BlockedPortError, DeadHostError)
    return next((place for place, kind in enumerate(order) if isinstance(problem, kind)), 9)


def problem_at(address: Address, timeout_s: float = _TIMEOUT_S) -> ClassroomError | None:
    """Return why an address cannot be reached, `None` if it can; takes `timeout_s` at most."""
    signs = _SignsOfLife(address.host)
    deadline = time.monotonic() + timeout_s
    while True:
        try:
            left = max(deadline - time.monotonic(), _PAUSE_S)
            with socket.create_connection((address.host, address.port), left):
                return None
        except socket.gaierror:
            return AddressError(address.host, "no machine of that name is known here")
        except TimeoutError:
            seen = signs.seen
            return (BlockedPortError if seen else DeadHostError)(address.host, address.port)
        except OSError as exc:
            if exc.errno not in _REFUSED:
                return DeadHostError(address.host, address.port)
        # A teacher's hub is closed for a moment whenever somebody is let in or out.
        if time.monotonic() + _PAUSE_S > deadline:
            return ClosedPortError(address.host, address.port)
        time.sleep(_PAUSE_S)


class _SignsOfLife:
    """Knocks at other ports meanwhile: any answer, even a refusal, shows a machine."""

    def __init__(self, host: str) -> None:
        self._host = host
        self._seen = threading.Event()
        for port in _SIGN_OF_LIFE_PORTS:
            threading.Thread(target=self._knock, args=(port,), daemon=True).start()

    @property
    def seen(self) -> bool:
        """Whether there was an answer by now."""
        return self._seen.is_set()

    def _knock(self, port: int) -> None:
        try:
            with socket.create_connection((self._host, port), _TIMEOUT_S):
                self._seen.set()
        except OSError as exc:
            if exc.errno in _REFUSED:
                self._seen.set()
