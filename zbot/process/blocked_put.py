"""Blocked puts of publishers, and functions that cancel them so that the process can end.

A put with congestion control `BLOCK` waits for at most a minute while a keep-all subscriber reads
nothing (see `wait_before_close`). During the put, its thread runs no signal handler, and Zenoh
cannot close the session. So when the process ends, this module shuts down the sockets of the
session's links. Then Zenoh sees that the other side is lost, and the put returns immediately.
docs/design/blocked-puts.md compares this with other ways.
"""

from __future__ import annotations

import contextlib
import os
import signal
import socket
import stat
import threading
import time
from collections import deque
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

import zenoh

from zbot.process import at_exit, signals
from zbot.threads.deadline import poll
from zbot.threads.weak_set import WeakSet
from zbot.transport.config import port_of

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

# A put that takes longer than this is blocked. A normal put takes milliseconds on a busy machine.
_BLOCKED_AFTER_S = 0.2
_RETURN_TIMEOUT_S = 1.0  # puts return within a millisecond after a link was cut
_PAUSE_S = 0.005
_DESCRIPTORS = Path("/dev/fd")  # does not exist on Windows, where links cannot be cut


class BlockingPublisher(Protocol):
    """Publisher whose puts can block.

    Attributes:
        is_putting: Whether a thread is inside a put.
        sent_count: Number of the present or last message.
    """

    is_putting: bool
    sent_count: int


#: The publishers of this process whose puts can block.
publishers: WeakSet[BlockingPublisher] = WeakSet()
#: The subscriptions of this process whose full queues block publishers.
local_queues: WeakSet[Any] = WeakSet()


class _SignalWatch:
    writer: socket.socket | None = None  #: Python writes the number of each signal into it
    thread: threading.Thread | None = None


def watch_signals() -> None:
    """Cancel blocked puts when a signal ends the program, until `unwatch_signals`.

    Publishers whose puts can block call this function. The function works only in the main thread,
    and only if no event loop has Python's wake-up descriptor for signals.
    """
    if _SignalWatch.writer or threading.current_thread() is not threading.main_thread():
        return
    reader, writer = socket.socketpair()
    writer.setblocking(False)
    previous = signal.set_wakeup_fd(writer.fileno(), warn_on_full_buffer=False)
    if previous != -1:
        signal.set_wakeup_fd(previous)
        reader.close()
        writer.close()
        return
    _SignalWatch.writer = writer
    thread = threading.Thread(target=_watch, args=(reader,), name="zbot signals", daemon=True)
    _SignalWatch.thread = thread
    thread.start()


def unwatch_signals() -> None:
    """Undo `watch_signals`. Do nothing if this is not the main thread."""
    writer, thread = _SignalWatch.writer, _SignalWatch.thread
    if writer is None or threading.current_thread() is not threading.main_thread():
        return
    _SignalWatch.writer = None
    present = signal.set_wakeup_fd(-1)
    if present not in {-1, writer.fileno()}:
        signal.set_wakeup_fd(present)  # an event loop has taken it since
    writer.close()  # ends the thread
    if thread is not None and thread.ident is not None:
        thread.join(_RETURN_TIMEOUT_S)


def leave_to_parent() -> None:
    """In a forked child, leave the watch and its socket to the parent process."""
    writer, _SignalWatch.writer, _SignalWatch.thread = _SignalWatch.writer, None, None
    publishers.clear()
    local_queues.clear()
    if writer is not None:
        present = signal.set_wakeup_fd(-1)
        if present not in {-1, writer.fileno()}:
            signal.set_wakeup_fd(present)
        writer.close()


def _watch(reader: socket.socket) -> None:
    # A blocked put in the main thread delays the signal handler. A blocked put in another thread
    # delays the exit. So this thread cancels the puts.
    with reader:
        while numbers := reader.recv(1):
            if signals.ends_program(numbers[0]):
                contexts = at_exit.open_contexts
                cancel_all(session for each in contexts for session in each.sessions)


def cancel_all(sessions: Iterable[zenoh.Session]) -> None:
    """Cut the links of sessions, so that all blocked puts return. Any thread may call this.

    Messages that are on their way are lost. The call takes at most 1.2 s if a put is blocked, and
    0.2 s if puts run but none of them is blocked. The call returns immediately if no put runs.
    """
    blocked = _blocked()
    if not blocked:
        return
    for session in sessions:
        _cut(session)
    for queue in local_queues:
        with contextlib.suppress(zenoh.ZError):  # the queue is undeclared
            deque(iter(queue.next_sample, None), maxlen=0)
    poll(lambda: not blocked & _puts(), _RETURN_TIMEOUT_S, _PAUSE_S)


def _blocked() -> set[tuple[int, int]]:
    puts = _puts()
    if puts:
        time.sleep(_BLOCKED_AFTER_S)
        puts &= _puts()
    return puts


def _puts() -> set[tuple[int, int]]:
    """Return the running puts, each as a publisher and the number of the message."""
    return {(id(each), each.sent_count) for each in publishers if each.is_putting}


def _cut(session: zenoh.Session) -> None:
    """Shut down the sockets of a session's links. The ports of a link identify its sockets."""
    with contextlib.suppress(zenoh.ZError):  # the session is closed
        links = {(port_of(str(link.src)), port_of(str(link.dst))) for link in session.info.links()}
        for end in _sockets():
            with end, contextlib.suppress(OSError):
                if (str(end.getsockname()[1]), str(end.getpeername()[1])) in links:
                    end.shutdown(socket.SHUT_RDWR)


def _sockets() -> Iterator[socket.socket]:
    """Yield a duplicate of each internet socket of this process. The caller must close it."""
    for path in list(_DESCRIPTORS.iterdir()) if _DESCRIPTORS.is_dir() else ():
        with contextlib.suppress(OSError):
            if stat.S_ISSOCK(os.fstat(int(path.name)).st_mode):
                end = socket.socket(fileno=os.dup(int(path.name)))
                if end.family in {socket.AF_INET, socket.AF_INET6}:
                    yield end
                else:
                    end.close()
