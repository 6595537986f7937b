"""Tests of SIGTERM: which programs it ends at once, and which may do the rest of their work."""

from __future__ import annotations

import signal
import sys
import time
from typing import TYPE_CHECKING

import pytest

from tests.conftest import allowed
from tests.integration.process.conftest import HEAD, LIMIT_S, stop_without_errors

if TYPE_CHECKING:
    from tests.conftest import Start

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")

#: Programs whose loop ends when SIGTERM has made `ok()` false, as in rclpy.
LOOPS = {
    "sleep": "while zbot.ok(): time.sleep(0.05)",
    "no node": "while zbot.ok(): time.sleep(0.05)",
    "context": "while robot.context.ok(): time.sleep(0.05)",
    "thread": """
def loop():
    while zbot.ok():
        time.sleep(0.05)
worker = threading.Thread(target=loop)
worker.start()
worker.join()""",
    "service": """
from std_srvs.srv import Trigger
client = robot.create_client(Trigger, "nobody")
while not client.wait_for_service(timeout_sec=0.05) and zbot.ok(): pass""",
    "asyncio": """
import asyncio
async def loop():
    while zbot.ok():
        await asyncio.sleep(0.05)
asyncio.run(loop())""",
}


@pytest.mark.parametrize(("kind", "by_zbot"), [("sleep", True), *((kind, False) for kind in LOOPS)])
def test_the_code_after_a_loop_runs_after_sigterm(start: Start, kind: str, by_zbot: bool) -> None:
    node = "" if kind == "no node" else "robot = Robot()"
    program = start(
        source=f"""{HEAD}
{node}
# Python misses a signal that comes just before it goes to sleep, e.g. in `join`.
threading.Timer(0.1, print, ["ready"], {{"flush": True}}).start()
{LOOPS[kind]}
print("motors stopped", flush=True)
""",
        by_zbot=by_zbot,
    )
    program.wait_for("ready")
    assert stop_without_errors(program, signal.SIGTERM) == 0
    assert program.lines[-1] == "motors stopped"


def test_a_program_that_got_the_exception_of_sigterm_may_take_its_time(start: Start) -> None:
    program = start(
        source=f"""{HEAD}
from zbot.process import signals
signals._LOOK_TIMEOUT_S = 0.2
robot = Robot()
context = zbot.get_default_context()
print("ready", flush=True)
while not context.is_interrupted: time.sleep(0.02)
try:
    zbot.spin(robot)
except zbot.ExternalShutdownException:
    time.sleep(1)  # longer than SIGTERM waits
    print("motors stopped", flush=True)
"""
    )
    program.wait_for("ready")
    assert stop_without_errors(program, signal.SIGTERM, 2 * LIMIT_S) == 0
    assert program.lines[-1] == "motors stopped"


#: Programs that never call `ok()`.
BLIND = {
    "sleep": "time.sleep(60)",
    "finally": """try: time.sleep(60)
finally: print("cleaned up")""",
    "compute": "while True: pass",
    "lock": "threading.Event().wait()",
    "clock": "while True: robot.get_clock().sleep_for(zbot.Duration(seconds=0.05))",
    "thread": """threading.Thread(target=zbot.spin, args=[robot], daemon=True).start()
time.sleep(60)""",
}


@pytest.mark.parametrize("kind", BLIND)
def test_sigterm_ends_a_program_that_does_not_call_ok_later(start: Start, kind: str) -> None:
    shorter = "from zbot.process import signals; signals._LOOK_TIMEOUT_S = 0.5"
    program = start(
        source=f"""
{HEAD}
{"" if kind == "sleep" else shorter}
robot = Robot()
# Python misses a signal just before it goes to sleep. So another thread prints this a little later.
threading.Timer(0.1, print, ["ready"], {{"flush": True}}).start()
{BLIND[kind]}
"""
    )
    program.wait_for("ready")
    begin = time.monotonic()
    assert stop_without_errors(program, signal.SIGTERM, LIMIT_S + 3) == -signal.SIGTERM
    took_s = time.monotonic() - begin
    # A second sleep_for() raises at once.
    assert kind == "clock" or took_s > (2 if kind == "sleep" else 0.4)
    assert (program.lines[-1] == "cleaned up") == (kind == "finally")


#: Waits that end at once after SIGTERM, and not after their time.
WAITS = {
    "service": 'robot.create_client(Trigger, "nobody").wait_for_service(timeout_sec=0.1)',
    "action": 'ActionClient(robot, Fibonacci, "nobody").wait_for_server(timeout_sec=0.1)',
    "message": 'wait_for_message(Trigger.Request, robot, "nothing", time_to_wait=0.1)[0]',
}


@pytest.mark.parametrize("wait", WAITS.values(), ids=WAITS)
def test_a_loop_of_waits_does_not_run_on_after_sigterm(start: Start, wait: str) -> None:
    program = start(
        source=f"""{HEAD}
from example_interfaces.action import Fibonacci
from std_srvs.srv import Trigger
from zbot.action import ActionClient
from zbot.remote.wait_for_message import wait_for_message
robot = Robot()
while not {wait}:
    print("waiting again", flush=True)
"""
    )
    program.wait_for("waiting again")
    program.new_lines()
    assert stop_without_errors(program, signal.SIGTERM) == -signal.SIGTERM
    assert len(program.new_lines()) < 20  # it would be thousands


#: Commands whose main thread runs a server. It does not call `ok()`.
SERVERS = {
    "view": ("viser", "view", "--no-browser", "--port", "0"),
    "web": ("nicegui", "web", "--no-browser", "--port", "0"),
    "foxglove": ("foxglove", "foxglove", "--port", "0"),
}


@pytest.mark.parametrize("name", SERVERS)
def test_sigterm_ends_a_server_without_waiting_for_ok(start: Start, name: str) -> None:
    extra, *words = SERVERS[name]
    pytest.importorskip(extra, reason=f"{extra} is not installed")
    program = start("zbot", *words)
    program.wait_for(f"zbot {name}: ")
    begin = time.monotonic()
    assert stop_without_errors(program, signal.SIGTERM, LIMIT_S + 3) == -signal.SIGTERM
    assert time.monotonic() - begin < allowed(2)  # SIGTERM waits 3 s for a call of ok()


def test_sigterm_during_a_rates_sleep_ends_the_program_without_output(start: Start) -> None:
    program = start(
        source=f"""{HEAD}
robot = Robot()
rate = robot.create_rate(0.01)
print("ready", flush=True)
try:
    rate.sleep()
finally:
    print("motors stopped", flush=True)
"""
    )
    program.wait_for("ready")
    assert stop_without_errors(program, signal.SIGTERM) == -signal.SIGTERM
    assert program.lines[-1] == "motors stopped"
