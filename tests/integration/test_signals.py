"""Tests of the ends of programs: no output, no delay, and the exit code of the signal."""

from __future__ import annotations

import os
import random
import signal
import sys
import threading
import time
from typing import TYPE_CHECKING

import pytest

from tests.conftest import allowed

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from tests.conftest import Program, Start

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")

LIMIT_S = 1.0
#: Set ZBOT_TEST_SEED to repeat the moments of a failed run.
SEED = os.environ.get("ZBOT_TEST_SEED", str(time.time_ns()))

HEAD = """
import sys, threading, time
import zbot
from std_msgs.msg import String

class Robot(zbot.Node):
    def __init__(self):
        super().__init__("robot")
        self.publisher = self.create_publisher(String, "chatter", 10)
        self.subscription = self.create_subscription(String, "chatter", self.listen, 1000)
        self.timer = self.create_timer(0.001, self.tick)

    def tick(self):
        self.publisher.publish(String(data="hello"))

    def listen(self, message):
        self.get_logger().debug(message.data)

zbot.init()
print("up", flush=True)
"""

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


def stop_without_errors(program: Program, number: int, limit_s: float = LIMIT_S) -> int:
    """Send a signal; check that the program ends in time without errors; return its exit code."""
    begin = time.monotonic()
    code = program.stop(number)
    took_s = time.monotonic() - begin
    for word in ("Traceback", "Error", "Exception", "panicked"):
        assert word not in program.output
    assert took_s < allowed(limit_s)
    return code


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM], ids=["SIGINT", "SIGTERM"])
@pytest.mark.parametrize("kind", PROGRAMS)
def test_a_signal_at_any_moment_ends_the_program_without_output(
    start: Start, kind: str, number: int
) -> None:
    moments = random.Random(f"{SEED} {kind} {number}")
    for _ in range(3):
        delay_s = moments.choice((0.02, 0.1, 0.3)) * moments.random()
        print(f"ZBOT_TEST_SEED={SEED}: signal {number} after {delay_s:.4f} s")
        program = start(source=PROGRAMS[kind])
        program.wait_for("up")
        threading.Event().wait(delay_s)
        # A loop that calls ok() may end before the exception is raised.
        assert stop_without_errors(program, number) in {
            -number,
            0 if "ok()" in PROGRAMS[kind] else -number,
        }


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


@pytest.mark.parametrize("thread", ["Thread-", "zbot meeting", "zbot /chatter"])
@pytest.mark.parametrize("then", ["zbot.spin(node)", "time.sleep(60)"])
def test_a_signal_during_the_start_of_a_thread_does_not_block_the_exit(
    start: Start, then: str, thread: str
) -> None:
    # The signal is sent again later, when the main thread may already sleep.
    program = start(source=STARTS.format(thread=thread, then=then))
    begin = time.monotonic()
    assert program.wait() == -signal.SIGINT
    assert time.monotonic() - begin < allowed(2 * LIMIT_S)
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


def test_publishing_works_while_the_program_ends(start: Start) -> None:
    listener = start(
        source="""
import zbot
from std_msgs.msg import String
with zbot.init():
    node = zbot.Node("listener")
    node.create_subscription(String, "farewell", lambda message: print(message.data), 10)
    print("ready", flush=True)
    zbot.spin(node)
"""
    )
    listener.wait_for("ready")
    program = start(
        source="""
import zbot
from std_msgs.msg import String
with zbot.init():
    node = zbot.Node("robot")
    publisher = node.create_publisher(String, "farewell", 10)
    node.create_guard_condition(lambda: print("ready", flush=True)).trigger()
    try:
        zbot.spin(node)
    finally:
        publisher.publish(String(data="stop the motors"))
"""
    )
    program.wait_for("ready")
    assert stop_without_errors(program, signal.SIGINT) == -signal.SIGINT
    listener.wait_for("stop the motors", timeout_s=2)


def test_two_signals_in_a_row_end_the_program_without_output(start: Start) -> None:
    program = start(source=PROGRAMS["spin"])
    program.wait_for("up")
    program.process.send_signal(signal.SIGINT)
    assert stop_without_errors(program, signal.SIGINT) in {-signal.SIGINT, 0}


def test_a_signal_during_the_exit_causes_no_output(start: Start) -> None:
    # The second Ctrl-C comes before Python calls the functions that close the contexts.
    program = start(
        source=HEAD
        + """
import signal
robot = Robot()
threading._register_atexit(signal.raise_signal, signal.SIGINT)
threading.Thread(target=zbot.spin, args=(robot,), daemon=True).start()
time.sleep(0.2)
"""
    )
    assert program.wait() in {0, -signal.SIGINT}
    assert "Traceback" not in program.output
    assert "Exception" not in program.output


INTERRUPTED_END = (
    HEAD
    + """
import signal
robot = Robot()
chosen = {call}
def trace(frame, event, arg):
    global chosen
    chosen -= frame.f_code.co_filename.endswith(("threading.py", "context.py", "publisher.py"))
    if not chosen:
        sys.settrace(None)
        signal.raise_signal(signal.SIGINT)
try:
    robot.create_timer(0.05, lambda: signal.raise_signal(signal.SIGINT))
    zbot.spin(robot)
finally:
    sys.settrace(trace)
    robot.destroy_node()
    zbot.shutdown()
"""
)


@pytest.mark.parametrize("turn", range(6))
def test_a_second_ctrl_c_at_any_call_of_the_exit_causes_no_output(start: Start, turn: int) -> None:
    # Python may raise at the start of each function, such as between a lock and its release.
    call = random.Random(f"{SEED}.{turn}").randint(1, 120)
    program = start(source=INTERRUPTED_END.replace("{call}", str(call)))
    assert program.wait() in {0, -signal.SIGINT}, f"call {call}"
    assert program.output == "up", f"call {call}"


def test_a_signal_handler_of_the_program_is_kept(start: Start) -> None:
    program = start(
        source="""
import signal, zbot
signal.signal(signal.SIGINT, lambda number, frame: print("own handler", flush=True))
zbot.init()
node = zbot.Node("robot")
node.create_guard_condition(lambda: print("ready", flush=True)).trigger()
try:
    zbot.spin(node)
except zbot.ExternalShutdownException:
    pass
print("spin ended")
"""
    )
    program.wait_for("ready")
    assert stop_without_errors(program, signal.SIGINT) == 0
    assert program.lines == ["ready", "own handler", "spin ended"]


# -- without a signal ------------------------------------------------------------------------------


def test_a_traceback_of_a_callback_begins_at_the_users_line(start: Start) -> None:
    program = start(
        source="""
import zbot

class Robot(zbot.Node):
    def __init__(self):
        super().__init__("robot")
        self.create_timer(0.001, self.tick)

    def tick(self):
        self.measure()

    def measure(self):
        return 1 / 0

with zbot.init():
    zbot.spin(Robot())
"""
    )
    assert program.wait() == 1
    assert program.lines[0] == "Traceback (most recent call last):"
    assert "in tick" in program.lines[1]
    assert "in measure" in program.output
    assert program.lines[-1] == "ZeroDivisionError: division by zero"
    assert f"{os.sep}zbot{os.sep}" not in program.output


@pytest.mark.parametrize(
    ("way", "code"),
    [
        ("pass", 0),
        ("sys.exit(3)", 3),
        ("raise SystemExit", 0),
        ("zbot.shutdown()", 0),
        ("zbot.shutdown(); zbot.shutdown()", 0),
        ("robot.destroy_node(); robot.destroy_node()", 0),
        ("robot.destroy_node(); zbot.shutdown()", 0),
        ("zbot.shutdown(); robot.destroy_node()", 0),
        ("raise ValueError('mine')", 1),
        ("threading.Thread(target=zbot.spin, args=(robot,), daemon=True).start()", 0),
        ("threading.Thread(target=zbot.spin, args=(robot,)).start(); zbot.shutdown()", 0),
    ],
)
def test_a_program_ends_after_its_last_line(start: Start, way: str, code: int) -> None:
    program = start(source=HEAD + f"robot = Robot()\nrobot.tick()\n{way}\n")
    program.wait_for("up")
    begin = time.monotonic()
    assert program.wait() == code
    assert time.monotonic() - begin < allowed(LIMIT_S)
    assert ("Traceback" in program.output) == ("mine" in way)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM], ids=["SIGINT", "SIGTERM"])
def test_a_thread_makes_a_node_and_spins_after_the_programs_last_line(
    start: Start, tmp_path: Path, number: int
) -> None:
    (tmp_path / "robot.py").write_text(
        """
import threading
import rclpy

def main():
    ended.wait()
    rclpy.init()
    node = rclpy.create_node("robot")
    node.create_timer(0.01, lambda: print("tick", flush=True))
    rclpy.spin(node)

ended = threading.Event()
threading.Thread(target=main).start()
ended.set()
"""
    )
    program = start("zbot", "run", "robot.py")
    for _ in range(3):
        program.wait_for("tick")
    assert stop_without_errors(program, number) == -number


def test_a_node_spins_in_a_thread_after_the_last_line_of_plain_python(start: Start) -> None:
    program = start(
        source="""
import threading, zbot
zbot.init()
node = zbot.Node("robot")
node.create_timer(0.01, lambda: print("tick", flush=True))
threading.Thread(target=zbot.spin, args=(node,)).start()
"""
    )
    for _ in range(3):
        program.wait_for("tick")
    assert stop_without_errors(program, signal.SIGINT) in {0, -signal.SIGINT}


def test_an_open_context_is_closed_at_exit(start: Start) -> None:
    program = start(
        source="""
import zbot
from std_msgs.msg import String
context = zbot.Context()
context.init()
node = zbot.Node("robot", context=context)
node.create_subscription(String, "chatter", print, 10)
print("up", node.get_node_names())
"""
    )
    assert program.wait() == 0
    assert program.lines == ["up ['robot']"]


def test_a_context_whose_shutdown_was_interrupted_is_closed_at_exit(start: Start) -> None:
    program = start(
        source="""
import zbot
zbot.init()
node = zbot.Node("robot")
context = zbot.get_default_context()
def interrupt():  # where a Ctrl-C may come, too
    context.remove_waker(interrupt)
    raise KeyboardInterrupt
context.add_waker(interrupt)
try:
    zbot.shutdown()
except KeyboardInterrupt:
    print("interrupted")
"""
    )
    assert program.wait() == 0
    assert program.lines == ["interrupted"]


def test_sigterm_during_a_sleep_is_visible_in_the_exit_status(start: Start) -> None:
    program = start(source=HEAD + "Robot()\nprint('asleep', flush=True)\ntime.sleep(60)\n")
    program.wait_for("asleep")
    assert stop_without_errors(program, signal.SIGTERM) == -signal.SIGTERM


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
