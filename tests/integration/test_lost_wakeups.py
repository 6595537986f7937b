"""Tests of signals that do not interrupt a sleep by themselves.

Such a Ctrl-C comes between Python's last check for signals and its sleep, or to another thread.
"""

from __future__ import annotations

import asyncio
import contextlib
import signal
import sys
import threading
import time
from typing import TYPE_CHECKING

import pytest

import zbot
from tests.conftest import allowed
from zbot.classroom.hub.process import serve_session
from zbot.executor.wait_set import WaitSet
from zbot.observer.serving.until_signal import serve_until_signal
from zbot.remote.wait_for_message import wait_for_message

from std_msgs.msg import String
from std_srvs.srv import Trigger

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import MakeContext

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")

_LONG_S = 3600


def _wait_set(node: zbot.Node) -> None:
    waiting = WaitSet()
    waiting.add_subscription(node.create_subscription(String, "news", print, 1).handle)
    waiting.wait(-1)


def _spin(node: zbot.Node) -> None:
    executor = zbot.SingleThreadedExecutor(context=node.context)
    executor.add_node(node)
    executor.spin()


WAITS: dict[str, Callable[[zbot.Node], object]] = {
    "graph": lambda node: node.context.graph.wait_for(lambda seen: not seen.tokens, _LONG_S),
    "wait set": _wait_set,
    "executor": _spin,
    "server": lambda node: node.create_client(Trigger, "absent").wait_for_service(),
    "message": lambda node: wait_for_message(String, node, "news"),
    "clock": lambda node: node.get_clock().sleep_for(
        zbot.Duration(seconds=_LONG_S), context=node.context
    ),
}


async def _serve(ready: Callable[[], object]) -> None:
    server = await asyncio.start_server(lambda *_: None, "127.0.0.1", 0)
    await serve_until_signal(server, ready)


def _interruption() -> threading.Timer:
    """Return a thread that gets SIGINT, so that the main thread does not wake."""
    return threading.Timer(0.2, signal.raise_signal, [signal.SIGINT])


@pytest.mark.parametrize("wait", WAITS.values(), ids=WAITS)
def test_no_wait_sleeps_through_a_signal(
    make_context: MakeContext, wait: Callable[[zbot.Node], object]
) -> None:
    node = zbot.Node("sleeper", context=make_context())
    interruption = _interruption()

    def wait_interrupted() -> None:
        interruption.start()  # on a busy machine, the signal may come before it returns
        wait(node)

    begun = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        wait_interrupted()
    assert time.monotonic() - begun < allowed(2)
    interruption.join()


def test_no_server_sleeps_through_a_signal() -> None:
    interruption = _interruption()
    begun = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        asyncio.run(_serve(interruption.start))
    assert time.monotonic() - begun < allowed(2)
    interruption.join()


def test_no_hub_sleeps_through_a_signal() -> None:
    interruption = _interruption()
    begun = time.monotonic()
    serve_session(contextlib.nullcontext, interruption.start)  # type: ignore[arg-type] # no session
    assert time.monotonic() - begun < allowed(2)
    interruption.join()
