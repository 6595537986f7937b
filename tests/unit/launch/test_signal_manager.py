"""Tests of the manager of signal handlers."""

from __future__ import annotations

import asyncio
import signal
import socket
import sys
import threading
import time

import pytest

from zbot.launch.signal_manager import AsyncSafeSignalManager

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")

_LATE_S = 10.0


def _signal_this_thread() -> None:
    signal.pthread_kill(threading.get_ident(), signal.SIGUSR1)


def test_a_signal_that_interrupts_no_wait_wakes_the_loop() -> None:
    async def wait_for_signal() -> int:
        loop = asyncio.get_running_loop()
        came: asyncio.Future[int] = loop.create_future()
        loop.call_later(2 * _LATE_S, lambda: None)  # ends the wait of a loop that sleeps on
        with AsyncSafeSignalManager(loop) as manager:
            manager.handle(signal.SIGUSR1, came.set_result)
            # A signal to another thread does not interrupt the wait of the loop's thread.
            thread = threading.Timer(0.1, _signal_this_thread)
            thread.start()
            number = await came
        thread.join()
        return number

    begin = time.monotonic()
    assert asyncio.run(wait_for_signal()) == signal.SIGUSR1
    assert time.monotonic() - begin < _LATE_S


def test_the_wakeup_descriptor_of_before_gets_the_signals() -> None:
    async def wait_for_signal(reader: socket.socket) -> bytes:
        loop = asyncio.get_running_loop()
        with AsyncSafeSignalManager(loop) as manager:
            manager.handle(signal.SIGUSR1, lambda _: None)
            signal.raise_signal(signal.SIGUSR1)
            return await loop.sock_recv(reader, 1)

    reader, writer = socket.socketpair()
    with reader, writer:
        reader.setblocking(False)
        writer.setblocking(False)
        before = signal.set_wakeup_fd(writer.fileno())
        try:
            assert asyncio.run(wait_for_signal(reader)) == bytes([signal.SIGUSR1])
            assert signal.set_wakeup_fd(-1) == writer.fileno()
        finally:
            signal.set_wakeup_fd(before)
