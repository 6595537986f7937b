"""A program that does not spin, or spins in the wrong thread, is told so once."""

from __future__ import annotations

import subprocess
import sys
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from pathlib import Path

pytestmark = [
    pytest.mark.usefixtures("domain"),
    pytest.mark.own_dialect("ROS 2's sessions warn of a missing router"),
]

HEAD = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
rclpy.init()
node = Node("quiet")
"""
TIMER = "node.create_timer(0.1, print)\n"
SUBSCRIPTION = "node.create_subscription(String, 't', print, 10)\n"
THREAD = """\
import threading
thread = threading.Thread(target=rclpy.spin, args=(node,), daemon=True)
"""
WARNING = (
    "{}:6: {}: the callback never ran, because the program ended without spinning: "
    "write rclpy.spin(node) before its end\n"
)


def run(folder: Path, rest: str) -> tuple[Path, str]:
    program = folder / "program.py"
    program.write_text(HEAD + rest)
    command = [sys.executable, str(program)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
    return program, done.stderr


@pytest.mark.parametrize(
    ("rest", "call"),
    [
        (TIMER, "create_timer"),
        (f"{SUBSCRIPTION}node.destroy_node()\nrclpy.shutdown()\n", "create_subscription"),
    ],
)
def test_a_forgotten_spin_is_named_once(tmp_path: Path, rest: str, call: str) -> None:
    program, errors = run(tmp_path, rest)
    assert errors == WARNING.format(program, call)


@pytest.mark.parametrize(
    "rest",
    [
        "node.create_publisher(String, 't', 10).publish(String(data='once'))\n",
        "node.create_rate(100).sleep()\n",
        f"{TIMER}{THREAD}thread.start()\nthread.join(0.5)\n",
        f"one = {SUBSCRIPTION}one.handle.take_message(String, False)",
    ],
)
def test_other_programs_are_left_alone(tmp_path: Path, rest: str) -> None:
    assert "never ran" not in run(tmp_path, rest)[1]


def running(folder: Path, rest: str) -> tuple[str, str]:
    """Return the first line that a program writes, and what it writes after that.

    The program reads its input until its end, and callbacks may wait only for a short time.
    """
    program = folder / "program.py"
    soon = "import sys; from zbot.node import state; state._SPIN_DELAY_S = 0.1\n"
    program.write_text(soon + HEAD + rest)
    pipe = subprocess.PIPE
    with subprocess.Popen([sys.executable, program], stdin=pipe, stderr=pipe, text=True) as process:
        assert process.stdin
        assert process.stderr
        line = process.stderr.readline()
        process.stdin.close()
        return line.partition(f"[quiet]: {program}:")[2], process.stderr.read()


def test_a_callback_behind_an_endless_loop_is_named_once(tmp_path: Path) -> None:
    line, rest = running(tmp_path, f"{TIMER}for line in sys.stdin: pass\n")
    assert line.startswith("7: create_timer: the callback has waited for 0.1 s")
    assert line.endswith("write rclpy.spin(node), and no endless loop before it\n")
    assert rest == ""


def test_a_node_whose_spin_waits_for_the_end_of_another_is_named(tmp_path: Path) -> None:
    spins = """\
import threading
other, is_spinning = Node("other"), threading.Event()
rclpy.get_global_executor().create_task(is_spinning.set)
threading.Thread(target=rclpy.spin, args=(other,)).start()
is_spinning.wait()
node.create_timer(0.1, print)
for line in sys.stdin: pass
rclpy.shutdown()
"""
    line, rest = running(tmp_path, spins)
    assert line.startswith("12: create_timer: the callback has waited for 0.1 s")
    assert "nothing spins this node, only another one: give both nodes to one executor" in line
    assert rest == ""


@pytest.mark.parametrize(
    ("call", "target"),
    [
        ("rclpy.spin(node)", "target=rclpy.spin, args=(node,)"),
        ("executor.spin()", "target=executor.spin"),
        ("many.spin()", "target=many.spin"),
    ],
)
def test_a_spin_in_place_of_a_thread_is_named(tmp_path: Path, call: str, target: str) -> None:
    spins = f"""\
import threading
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
executor, many = SingleThreadedExecutor(), MultiThreadedExecutor()
(many if "many" in {call!r} else executor).add_node(node)
node.create_timer(0.01, rclpy.shutdown)
thread = threading.Thread(
    target={call},
)
"""
    program, errors = run(tmp_path, spins)
    text = f"{program}:12: the spin runs here, and not in the thread: write {target}\n"
    assert errors.partition("[zbot]: ")[2] == text
