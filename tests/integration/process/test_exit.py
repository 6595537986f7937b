"""Tests of the exit of programs: their output and their exit code."""

from __future__ import annotations

import os
import random
import signal
import sys
import time
from typing import TYPE_CHECKING

import pytest

from tests.conftest import allowed
from tests.integration.process.conftest import HEAD, LIMIT_S, SEED, stop_without_errors

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import Start

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")


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
    listener.wait_for("stop the motors", timeout=2)


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
""",
        by_zbot=True,
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
    files = ("threading.py", "context.py", "state.py", "session.py", "threads.py", "publisher.py")
    chosen -= frame.f_code.co_filename.endswith(files)
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
    program = start(source=INTERRUPTED_END.replace("{call}", str(call)), by_zbot=True)
    assert program.wait() in {0, -signal.SIGINT}, f"call {call}"
    assert program.output == "up", f"call {call}"


def test_zbot_run_freezes_the_loaded_modules_for_the_garbage_collector(start: Start) -> None:
    program = start(source="import gc\nprint(gc.get_freeze_count() > 10_000)", by_zbot=True)
    assert (program.wait(), program.output) == (0, "True")


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
""",
        by_zbot=True,
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
        ("zbot.shutdown()", 0),
        ("raise ValueError('mine')", 1),
        ("threading.Thread(target=zbot.spin, args=(robot,), daemon=True).start()", 0),
        ("threading.Thread(target=zbot.spin, args=(robot,)).start(); zbot.shutdown()", 0),
    ],
)
def test_a_program_ends_after_its_last_line(start: Start, way: str, code: int) -> None:
    source = f"{HEAD}robot = Robot()\nrobot.tick()\nprint('last', flush=True)\n{way}\n"
    program = start(source=source, by_zbot=True)
    program.wait_for("last")
    begin = time.monotonic()
    assert program.wait() == code
    assert time.monotonic() - begin < allowed(LIMIT_S)
    assert ("Traceback" in program.output) == ("mine" in way)


def test_a_thread_that_spins_at_the_end_of_plain_python_ends_without_output(start: Start) -> None:
    # In one of five such ends, the thread got the exception before Python ended it.
    source = f"""{HEAD}
robot = Robot()
threading.Thread(target=zbot.spin, args=[robot], daemon=True).start()
"""
    for turn in range(6):
        program = start(source=f"{source}time.sleep(0.02 * {turn})\n")
        assert program.wait() == 0
        assert program.output == "up"


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
    # As with rclpy, Python prints the exception that ends `spin` in the thread.
    assert program.stop(signal.SIGINT) in {0, -signal.SIGINT}


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
    first, warning = program.lines
    assert first == "up ['robot']"
    assert "create_subscription: the callback never ran" in warning
