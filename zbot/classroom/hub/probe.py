"""Probe of a TCP port. It finds out why a hub cannot be reached. Zenoh does not report this."""

from __future__ import annotations

import errno
import ipaddress
import queue
import socket
import threading
import time
from typing import TYPE_CHECKING

from zbot.classroom.errors import (
    BlockedPortError,
    ClassroomError,
    ClosedPortError,
    UnreachableHostError,
    address_error,
)
from zbot.threads.deadline import Deadline

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.classroom.hub.address import Address

# A connection in one building takes milliseconds, and on bad Wi-Fi up to a second. TCP repeats a
# lost packet after 1 s.
_TIMEOUT_S = 2.5
_LOOK_UP_S = 0.3
_LATE_S = 5.0  # longest delay of a thread on a busy machine
_PAUSE_S = 0.05  # between attempts if the port refuses the connection
_REOPENING_S = 3.0  # a hub that is opened again is closed for up to 1 s, on a busy machine longer
# A machine that is on usually accepts or refuses a connection on at least one of these ports.
_COMMON_PORTS = (22, 80, 135, 445, 5000, 7)
_REFUSED = {errno.ECONNREFUSED, getattr(errno, "WSAECONNREFUSED", errno.ECONNREFUSED)}


def first_reachable(candidates: Sequence[Address], timeout_s: float = _TIMEOUT_S) -> Address:
    """Try all addresses in parallel, and return the first that accepts a TCP connection.

    If all addresses fail, the error is about the address where the probe came nearest to a
    connection.

    Raises:
        UnreachableHostError: No machine answers.
        BlockedPortError: A machine answers, but a firewall drops the packets to the port.
        ClosedPortError: A machine answers, but no program listens on the port.
        ClassValueError: The name is unknown, or no name server answers.
    """
    answers: queue.SimpleQueue[tuple[Address, ClassroomError | None]] = queue.SimpleQueue()

    def look(address: Address) -> None:
        answers.put((address, problem_at(address, timeout_s)))

    for candidate in candidates:
        threading.Thread(target=look, args=(candidate,), daemon=True).start()
    # A name look-up has no timeout of its own and may take longer than a connection.
    has_names = not all(_is_ip(candidate.host) for candidate in candidates)
    patience_s = _LOOK_UP_S if has_names else _LATE_S
    problems: list[ClassroomError] = []
    for candidate in candidates:
        try:
            address, problem = answers.get(timeout=timeout_s + _REOPENING_S + patience_s)
        except queue.Empty:
            raise address_error(
                candidate.host, "no name server answers: use the IP address"
            ) from None
        if problem is None:
            return address
        problems.append(problem)
    raise min(problems, key=_rank)


def _is_ip(host: str) -> bool:
    try:
        ipaddress.ip_address(host)
    except ValueError:
        return False
    return True


def _rank(problem: ClassroomError) -> int:
    """Return a problem's rank. A lower rank means that the probe came nearer to a connection."""
    order = (ClosedPortError, BlockedPortError, UnreachableHostError)
    return next((place for place, kind in enumerate(order) if isinstance(problem, kind)), 9)


def problem_at(
    address: Address, timeout_s: float = _TIMEOUT_S, reopening_s: float = _REOPENING_S
) -> ClassroomError | None:
    """Return why an address cannot be reached, or `None`.

    Args:
        address: The address.
        timeout_s: How long to wait for each answer. The time of a name look-up is not counted.
        reopening_s: How long to try again if the port refuses. A hub may be opened again at this
            moment.
    """
    other_ports = _OtherPorts(address.host)
    reopened = Deadline(reopening_s)
    while True:
        try:
            with socket.create_connection((address.host, address.port), timeout_s):
                return None
        except socket.gaierror:
            return address_error(address.host, "no machine of that name is known here")
        except TimeoutError:
            kind = BlockedPortError if other_ports.answered else UnreachableHostError
            return kind(address.host, address.port)
        except OSError as exc:
            if exc.errno not in _REFUSED:
                return UnreachableHostError(address.host, address.port)
        # Try again, because a teacher's hub is closed for a moment when its access rules change.
        if reopened.left_s < _PAUSE_S:
            return ClosedPortError(address.host, address.port)
        time.sleep(_PAUSE_S)


class _OtherPorts:
    """Connections to a host's common ports. An answer or a refusal shows that the host is on."""

    def __init__(self, host: str) -> None:
        self._host = host
        self._answered = threading.Event()
        for port in _COMMON_PORTS:
            threading.Thread(target=self._connect, args=(port,), daemon=True).start()

    @property
    def answered(self) -> bool:
        """Whether the host has answered on any of the ports."""
        return self._answered.is_set()

    def _connect(self, port: int) -> None:
        try:
            with socket.create_connection((self._host, port), _TIMEOUT_S):
                self._answered.set()
        except OSError as exc:
            if exc.errno in _REFUSED:
                self._answered.set()
