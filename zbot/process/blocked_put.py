"""Blocked puts of publishers, and functions that cancel them so that the process can end.

A put with congestion control `BLOCK` waits for at most a minute while a keep-all subscriber reads
nothing (see `wait_before_close`). During the put no signal handler runs in its thread, and Zenoh
cannot close the session. This module therefore shuts down the sockets of the session's links. Then
Zenoh sees that the other side is lost, and the put returns at once.
"""

from __future__ import annotations

import contextlib
import gc
import os
import signal
import socket
import stat
import sys
import threading
import time
from collections import deque
from pathlib import Path
from typing import TYPE_CHECKING, Any

import zenoh

from zbot.process import at_exit
from zbot.transport.config import port_of
from zbot.transport.weak_set import WeakSet

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator
    from types import CodeType, FrameType

# A put that takes longer is blocked. On a busy machine, a normal put takes milliseconds.
_BLOCKED_AFTER_S = 0.2
_RETURN_TIMEOUT_S = 1.0  # puts return within a millisecond after a link was cut
_PAUSE_S = 0.005
_DESCRIPTORS = Path("/dev/fd")  # does not exist on Windows, where links cannot be cut

#: The functions of a publisher that call Zenoh's put.
put_functions: set[CodeType] = set()
#: The subscriptions of this process whose full queues block publishers.
local_queues: WeakSet[Any] = WeakSet()


class _SignalWatch:
    is_needed = False  # whether there is, or was, a publisher whose puts can block
    is_installed = False


def watch_signals() -> None:
    """Cancel blocked puts when a signal comes. Publishers call this if their puts can block.

    This works only in the main thread, and only if no event loop has a wake-up descriptor for
    signals.
    """
    _SignalWatch.is_needed = True
    if _SignalWatch.is_installed or threading.current_thread() is not threading.main_thread():
        return
    reader, writer = socket.socketpair()
    writer.setblocking(False)
    previous = signal.set_wakeup_fd(writer.fileno(), warn_on_full_buffer=False)
    if previous != -1:
        signal.set_wakeup_fd(previous)
        return
    _SignalWatch.is_installed = True
    arguments = (reader, writer)
    threading.Thread(target=_watch, args=arguments, name="zbot signals", daemon=True).start()


def _watch(reader: socket.socket, _writer: socket.socket) -> None:
    # A put of the main thread delays the signal handler. A put of another thread delays the exit.
    while reader.recv(1):
        cancel_all(session for context in at_exit.open_contexts for session in context.sessions)


def cancel_all(sessions: Iterable[zenoh.Session]) -> None:
    """Cut the links of sessions, so that all blocked puts return. Any thread may call this.

    Messages that are on their way are lost. The call takes at most 1.2 s if a put is blocked, and
    at most 0.2 s if puts run without being blocked. It returns at once if no put runs.
    """
    blocked = _SignalWatch.is_needed and _blocked()
    if not blocked:
        return
    for session in sessions:
        _cut(session)
    for queue in local_queues:
        with contextlib.suppress(zenoh.ZError):  # the queue is undeclared
            deque(iter(queue.next_sample, None), maxlen=0)
    deadline = time.monotonic() + _RETURN_TIMEOUT_S
    while blocked & _puts() and time.monotonic() < deadline:
        time.sleep(_PAUSE_S)


def _blocked() -> set[tuple[int, int, int]]:
    puts = _puts()
    if puts:
        time.sleep(_BLOCKED_AFTER_S)
        puts &= _puts()
    return puts


def _puts() -> set[tuple[int, int, int]]:
    """Return the running puts, each as a thread, a publisher and the number of the message."""
    found = set()
    for thread, frame in _frames().items():
        if frame.f_code in put_functions:
            publisher = frame.f_locals["self"]
            found.add((thread, id(publisher), publisher.sent_count))
    return found


def _frames() -> dict[int, FrameType]:
    # Python 3.11 and older hold a lock during this call. A garbage collection lets other threads
    # run. If one of them ends, it waits for this lock and lets no thread run. The two threads would
    # wait for each other for ever, so there must be no collection.
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        return sys._current_frames()  # noqa: SLF001 - Python has no other way
    finally:
        if was_enabled:
            gc.enable()


def _cut(session: zenoh.Session) -> None:
    """Shut down the sockets of a session's links. Zenoh tells only the addresses of a link."""
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
