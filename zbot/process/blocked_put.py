"""Puts that wait for room where nobody makes any, and how their process ends all the same.

A put with congestion control `BLOCK` waits while a subscriber takes nothing, up to a minute (see
`wait_before_close`). No signal's handler runs in its thread meanwhile, and Zenoh cannot close the
session before it has returned. So whoever wants to end cuts the session's links: Zenoh takes that
for the loss of the other side, and the put returns at once.
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

# A put that takes longer is waited for in vain: on a busy machine one takes milliseconds.
_PATIENCE_S = 0.2
_RETURN_S = 1.0  # that a link is cut is noticed within a millisecond
_PAUSE_S = 0.005
_DESCRIPTORS = Path("/dev/fd")  # not on Windows, where links cannot be cut

#: The functions in which a publisher's thread stands while Zenoh puts.
callers: set[CodeType] = set()
#: The subscriptions of this process whose full queues hold up their publishers.
own_queues: WeakSet[Any] = WeakSet()


class _Watch:
    is_needed = False  # whether there is, or was, a publisher whose puts may wait
    is_on = False


def watch_signals() -> None:
    """Let a signal release the puts that wait; for each publisher whose puts may.

    The signal does so if this is the main thread, and no event loop listens for signals.
    """
    _Watch.is_needed = True
    if _Watch.is_on or threading.current_thread() is not threading.main_thread():
        return
    reader, writer = socket.socketpair()
    writer.setblocking(False)
    loops = signal.set_wakeup_fd(writer.fileno(), warn_on_full_buffer=False)
    if loops != -1:
        signal.set_wakeup_fd(loops)
        return
    _Watch.is_on = True
    threading.Thread(target=_watch, args=(reader, writer), name="zbot signals", daemon=True).start()


def _watch(reader: socket.socket, _writer: socket.socket) -> None:
    # The main thread's put keeps the signal's handler from running, any other the program's end.
    while reader.recv(1):
        release(session for context in at_exit.open_contexts for session in context.sessions)


def release(sessions: Iterable[zenoh.Session]) -> None:
    """Let the puts return that wait in vain, by cutting the links of sessions.

    What is under way on them is lost. Returns at once where no put is under way, else within 0.2 s
    where none waits, and 1.2 s otherwise; from any thread.
    """
    blocked = _Watch.is_needed and _blocked()
    if not blocked:
        return
    for session in sessions:
        _cut(session)
    for queue in own_queues:
        with contextlib.suppress(zenoh.ZError):  # it is undeclared
            deque(iter(queue.next_sample, None), maxlen=0)
    deadline = time.monotonic() + _RETURN_S
    while blocked & _puts() and time.monotonic() < deadline:
        time.sleep(_PAUSE_S)


def _blocked() -> set[tuple[int, int, int]]:
    """Return the puts that do not get on."""
    puts = _puts()
    if puts:
        time.sleep(_PATIENCE_S)
        puts &= _puts()
    return puts


def _puts() -> set[tuple[int, int, int]]:
    """Return the puts under way: their threads, publishers, and numbers."""
    found = set()
    for thread, frame in _frames().items():
        if frame.f_code in callers:
            publisher = frame.f_locals["self"]
            found.add((thread, id(publisher), publisher.sent_count))
    return found


def _frames() -> dict[int, FrameType]:
    """Return what each thread does just now."""
    # Python 3.11 and older hold a lock meanwhile that a thread waits for when it ends, without
    # letting others run. To collect garbage may let it run: then both wait for good.
    collects = gc.isenabled()
    gc.disable()
    try:
        return sys._current_frames()  # noqa: SLF001 - Python has no other way
    finally:
        if collects:
            gc.enable()


def _cut(session: zenoh.Session) -> None:
    """Shut down the sockets of a session's links, of which Zenoh tells the addresses only."""
    with contextlib.suppress(zenoh.ZError):  # it is closed
        links = {(port_of(str(link.src)), port_of(str(link.dst))) for link in session.info.links()}
        for end in _sockets():
            with end, contextlib.suppress(OSError):
                if (str(end.getsockname()[1]), str(end.getpeername()[1])) in links:
                    end.shutdown(socket.SHUT_RDWR)


def _sockets() -> Iterator[socket.socket]:
    """Open each internet socket of this process a second time; the caller closes it."""
    for path in list(_DESCRIPTORS.iterdir()) if _DESCRIPTORS.is_dir() else ():
        with contextlib.suppress(OSError):
            if stat.S_ISSOCK(os.fstat(int(path.name)).st_mode):
                end = socket.socket(fileno=os.dup(int(path.name)))
                if end.family in {socket.AF_INET, socket.AF_INET6}:
                    yield end
                else:
                    end.close()
