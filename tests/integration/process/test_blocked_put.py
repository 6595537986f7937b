"""Tests of puts that wait for a keep-all subscription."""

from __future__ import annotations

import signal
import sys
from typing import TYPE_CHECKING

import pytest

import zbot
from tests.conftest import wait_until

from std_msgs.msg import Int64

if TYPE_CHECKING:
    from tests.conftest import MakeContext, Spin, Start

# More than the buffers of the sockets take: a sender that never waits would test nothing.
COUNT = 200_000

#: Publishes until the subscription is full, and says that it waits.
SENDER = f"""
import signal, threading, time
import zbot
from std_msgs.msg import Int64

signal.signal(signal.{{name}}, lambda number, frame: print("handled", flush=True))
zbot.init(signal_handler_options=zbot.SignalHandlerOptions.SIGTERM)
node = zbot.Node("sender")
keep_all = zbot.QoSProfile(history=zbot.HistoryPolicy.KEEP_ALL)
publisher = node.create_publisher(Int64, "numbers", keep_all)

def tell():
    sent = 0
    while not 0 < sent == publisher.sent_count:
        sent = publisher.sent_count
        time.sleep(0.3)
    print("waits", flush=True)

threading.Thread(target=tell, daemon=True).start()
for number in range({COUNT}):
    publisher.publish(Int64(data=number))
print("sent", flush=True)
threading.Event().wait()  # its end would drop what the subscription has not read
"""


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
@pytest.mark.parametrize("name", ["SIGUSR1", "SIGINT"])
def test_a_signal_that_does_not_end_the_program_loses_no_message(
    start: Start, make_context: MakeContext, spin: Spin, name: str
) -> None:
    listener = zbot.Node("listener", context=make_context())
    heard: list[int] = []
    keep_all = zbot.QoSProfile(history=zbot.HistoryPolicy.KEEP_ALL)
    listener.create_subscription(
        Int64, "numbers", lambda message: heard.append(message.data), keep_all
    )
    sender = start(source=SENDER.replace("{name}", name))
    sender.wait_for("waits")
    sender.process.send_signal(getattr(signal, name))
    spin(listener)
    sender.wait_for("sent", timeout=30)
    assert wait_until(lambda: len(heard) >= COUNT), len(heard)
    assert heard == list(range(COUNT))
    assert "handled" in sender.lines
