"""Tests of signals that end programs: no output, and the exit code of the signal."""

from __future__ import annotations

import random
import signal
import sys
import threading
import time
from typing import TYPE_CHECKING

import pytest

from tests.conftest import allowed, wait_until
from tests.integration.process.conftest import HEAD, LIMIT_S, SEED, stop_without_errors

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import Program, Start

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")

PROGRAMS = {
    "spin": HEAD + "zbot.spin(Robot())",
    "spin_once": HEAD
    + """
robot = Robot()
while zbot.ok():
    zbot.spin_once(robot, timeout_sec=0.01)
""",
    "threads": HEAD
    + """
executor = zbot.MultiThreadedExecutor()
executor.add_node(Robot())
threading.Thread(target=executor.spin, daemon=True).start()
while True:
    time.sleep(0.2)  # Python itself misses a signal just before it goes to sleep
""",
    "sleep": HEAD
    + """
def work():
    while True:
        time.sleep(0.2)  # as above

robot = Robot()
robot.timer.callback = work
zbot.spin(robot)
""",
    "publish": HEAD
    + """
robot = Robot()
while True:
    robot.tick()
""",
    "rate": HEAD
    + """
robot = Robot()
rate = robot.create_rate(1000)
while zbot.ok():
    robot.tick()
    rate.sleep()
""",
}

LESSON = """
import zbot as rclpy
from zbot import Node

class MinimalNode(Node):
    def __init__(self):
        super().__init__('minimal_node')
        self.get_logger().info('Hello from ROS2!')

def main(args=None):
    rclpy.init(args=args)
    node = MinimalNode()
    rclpy.spin(node)
    node.destroy_node()
    rclpy.shutdown()

if __name__ == '__main__':
    main()
"""

STARTS = """
import signal, threading, time
import zbot

start = threading.Thread.start

def interrupted(thread):
    # A timer is what lets a signal come again.
    if thread.name.startswith("{thread}") and not isinstance(thread, threading.Timer):
        signal.raise_signal(signal.SIGINT)
    start(thread)

zbot.init()
threading.Thread.start = interrupted
node = zbot.Node("robot")
node.create_subscription(zbot.interfaces.get_message("std_msgs/msg/String"), "chatter", print, 10)
{then}
"""

IMPORTS = """
import functools, operator, signal, sys, threading
from collections import deque
import zbot

zbot.init()
bootstrap = sys.modules["_frozen_importlib"]
imp = bootstrap._imp

class Interrupted:
    # Without a frame of Python in between: the signal comes right behind the lock.
    once = [imp.acquire_lock, functools.partial(signal.raise_signal, signal.SIGINT)]

    def __getattr__(self, name):
        if name == "acquire_lock" and self.once:
            calls, Interrupted.once = self.once, []
            return functools.partial(deque, map(operator.methodcaller("__call__"), calls), 0)
        return getattr(imp, name)

bootstrap._imp = Interrupted()
try:
    import colorsys
    threading.Event().wait(5)
except KeyboardInterrupt:
    other = threading.Thread(target=__import__, args=("sched",), daemon=True)
    other.start()
    other.join(30)
    print("imports", not other.is_alive())
"""

GUARDED = """
import signal, threading, zbot.compat, rclpy
from rclpy.signals import SignalHandlerGuardCondition
from zbot.executor.wait_set import WaitSet

rclpy.init()
guard = SignalHandlerGuardCondition()
waiting = WaitSet()
waiting.add_guard_condition(guard.handle)
helper = threading.Thread(target=waiting.wait, args=(-1,))
helper.start()
try:
    signal.raise_signal(signal.SIGINT)
except KeyboardInterrupt:
    helper.join(5)
    print("woken:", waiting.is_ready("guard_condition", 0))
guard.destroy()
rclpy.shutdown()
"""

#: Publishes to a keep-all subscription that reads nothing, until a put is blocked.
FLOOD = """
import sys, threading, time
import zbot
from std_msgs.msg import String

KEEP_ALL = zbot.QoSProfile(history=zbot.HistoryPolicy.KEEP_ALL)
zbot.init()
node = zbot.Node("flood")
publisher = node.create_publisher(String, "flood", KEEP_ALL)
if sys.argv[1] == "itself":
    node.create_subscription(String, "flood", print, KEEP_ALL)
while not node.count_subscribers("flood"):
    time.sleep(0.01)

def flood():
    while zbot.ok():
        publisher.publish(String(data="wave"))

def tell():
    sent = 0
    while not 0 < sent == publisher.sent_count:
        sent = publisher.sent_count
        time.sleep(0.3)
    print("waits", flush=True)

threading.Thread(target=tell).start()
if sys.argv[2] == "main":
    flood()
threading.Thread(target=flood).start()
zbot.spin(zbot.Node("idle"))
"""

STANDING_SUBSCRIBER = """
import time
import zbot
from std_msgs.msg import String

zbot.init()
node = zbot.Node("standing")
keep_all = zbot.QoSProfile(history=zbot.HistoryPolicy.KEEP_ALL)
node.create_subscription(String, "flood", print, keep_all)
time.sleep(60)
"""


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM], ids=["SIGINT", "SIGTERM"])
@pytest.mark.parametrize("kind", PROGRAMS)
def test_a_signal_at_any_moment_ends_the_program_without_output(
    start: Start, kind: str, number: int
) -> None:
    moments = random.Random(f"{SEED} {kind} {number}")
    # SIGTERM waits 3 s for a call of ok(). A loop that calls ok() ends normally.
    looks = "ok()" in PROGRAMS[kind]
    waits = number == signal.SIGTERM and kind in {"publish", "threads"}
    delay_s = moments.choice((0.02, 0.1, 0.3)) * moments.random()
    print(f"ZBOT_TEST_SEED={SEED}: signal {number} after {delay_s:.4f} s")
    program = start(source=PROGRAMS[kind])
    program.wait_for("up")
    threading.Event().wait(delay_s)
    code = stop_without_errors(program, number, LIMIT_S + 3 * waits)
    assert code in {-number, 0 if looks else -number}


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM], ids=["SIGINT", "SIGTERM"])
@pytest.mark.parametrize("thread", ["main", "other"])
@pytest.mark.parametrize("whom", ["itself", "another"])
def test_a_signal_ends_a_program_that_waits_for_a_subscriber(
    start: Start, whom: str, thread: str, number: int
) -> None:
    if whom == "another":
        start(source=STANDING_SUBSCRIBER)
    program = start(whom, thread, source=FLOOD)
    program.wait_for("waits")
    # Zenoh may be connecting again to the stopped process; it closes after that.
    assert stop_without_errors(program, number, 4 * LIMIT_S) == -number


@pytest.mark.parametrize("thread", ["zbot meeting", "zbot diagnostics"])
# Python misses a signal that comes just before it goes to sleep: it may sleep again, and shortly.
@pytest.mark.parametrize("then", ["zbot.spin(node)", "for _ in range(600): time.sleep(0.1)"])
def test_a_signal_during_the_start_of_a_thread_does_not_block_the_exit(
    start: Start, then: str, thread: str
) -> None:
    # The signal is sent again later, when the main thread may already sleep.
    program = start(source=STARTS.format(thread=thread, then=then))
    begin = time.monotonic()
    assert program.wait() == -signal.SIGINT
    assert time.monotonic() - begin < allowed(4 * LIMIT_S)  # most of it is the start of Python
    assert not program.output


def test_a_signal_during_an_import_releases_the_import_lock(start: Start) -> None:
    program = start(source=IMPORTS)
    program.wait()
    assert program.output == "imports True"


def test_the_example_of_the_lesson_ends_without_output(start: Start) -> None:
    program = start(source=LESSON)
    program.wait_for("Hello from ROS2!")
    assert stop_without_errors(program, signal.SIGINT) == -signal.SIGINT
    assert len(program.lines) == 1


@pytest.mark.parametrize(
    ("caught", "number"),
    [
        ("KeyboardInterrupt", signal.SIGINT),
        ("zbot.ExternalShutdownException", signal.SIGTERM),
        ("(KeyboardInterrupt, zbot.ExternalShutdownException)", signal.SIGINT),
        ("(KeyboardInterrupt, zbot.ExternalShutdownException)", signal.SIGTERM),
    ],
)
def test_a_program_that_catches_the_exception_ends_normally(
    start: Start, caught: str, number: int
) -> None:
    program = start(
        source=f"""
import zbot
zbot.init()
node = zbot.Node("robot")
node.create_guard_condition(lambda: print("ready", flush=True)).trigger()
try:
    zbot.spin(node)
except {caught}:
    print("caught", zbot.ok())
finally:
    node.destroy_node()
    zbot.try_shutdown()
print("end")
"""
    )
    program.wait_for("ready")
    assert stop_without_errors(program, number) == 0
    assert program.lines == ["ready", "caught False", "end"]


def test_two_signals_in_a_row_end_the_program_without_output(start: Start) -> None:
    program = start(source=PROGRAMS["spin"])
    program.wait_for("up")
    program.process.send_signal(signal.SIGINT)
    assert stop_without_errors(program, signal.SIGINT) in {-signal.SIGINT, 0}


THREAD_THAT_GOES_ON = """
import threading, zbot
from zbot.process import at_exit
zbot.init()
node = zbot.Node("robot")

def work():
    at_exit.wait_for_end(60)
    print("goes on", flush=True)
    threading.Event().wait()

threading.Thread(target=work).start()
print("ready", flush=True)
zbot.spin(node)
"""


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM], ids=["SIGINT", "SIGTERM"])
def test_a_second_signal_ends_a_program_whose_threads_go_on(start: Start, number: int) -> None:
    program = start(source=THREAD_THAT_GOES_ON)
    program.wait_for("ready")
    program.process.send_signal(number)
    program.wait_for("goes on")

    def has_ended() -> bool:
        program.process.send_signal(number)
        return program.process.poll() is not None

    assert wait_until(has_ended, 20)
    assert program.wait() == -number
    assert "Traceback" not in program.output


def test_a_signal_in_an_import_of_a_module_in_cpp_prints_no_traceback(start: Start) -> None:
    program = start(
        source="""
try:
    raise KeyboardInterrupt
except KeyboardInterrupt as interrupt:
    raise ImportError("initialization failed") from interrupt
""",
        by_zbot=True,
    )
    assert program.wait() == -signal.SIGINT
    assert program.lines == []


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM], ids=["SIGINT", "SIGTERM"])
def test_a_command_does_not_lose_a_signal_in_a_destructor(start: Start, number: int) -> None:
    program = start(
        source=f"""
import signal, time
from zbot.process import signals
from zbot_cli.input import keyboard_interrupt

class Thing:
    def __del__(self):
        signal.raise_signal({number:d})

keyboard_interrupt.end_process_on_ctrl_c()
keyboard_interrupt.raise_on_ctrl_c()
signals.install(calls_ok=False)
Thing()
while True:
    time.sleep(0.2)
"""
    )
    assert program.wait(10) == -number
    assert program.lines == []


LOCAL_CALLS = """
import zbot
from std_srvs.srv import Trigger
zbot.init()
node = zbot.Node("both")
node.create_service(Trigger, "ask", lambda request, response: response)
client = node.create_client(Trigger, "ask")
print("ready", flush=True)
while zbot.ok():
    zbot.spin_until_future_complete(node, client.call_async(Trigger.Request()))
"""


def test_ctrl_c_is_not_lost_in_callbacks_of_zenoh(start: Callable[..., Program]) -> None:
    # A service of the same process is called in the main thread, from Rust.
    for turn in range(4):
        program = start(source=LOCAL_CALLS)
        program.wait_for("ready")
        assert program.stop(signal.SIGINT, 3) in {0, -signal.SIGINT}, turn
        assert "error" not in program.output.lower()


def test_ctrl_c_wakes_a_wait_set_with_its_guard_condition(start: Start) -> None:
    program = start(source=GUARDED)
    program.wait_for("woken: True")
    assert program.wait() == 0
