"""Tests of forked child processes: they end, use no node of the parent, and may have own nodes."""

from __future__ import annotations

import signal
import sys
from typing import TYPE_CHECKING

import pytest

from tests.conftest import allowed

if TYPE_CHECKING:
    from tests.conftest import Start

pytestmark = [
    pytest.mark.skipif(sys.platform == "win32", reason="Windows has no fork"),
    pytest.mark.timeout(120),
]

#: The parent has a node, and another thread spins it and publishes.
PARENT = """
import multiprocessing, os, signal, subprocess, sys, threading, time, warnings
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

warnings.simplefilter("ignore", DeprecationWarning)  # of fork() in a process with threads
signal.signal(signal.SIGINT, signal.default_int_handler)  # it is ignored in jobs of a shell script
rclpy.init()
node = Node("parent")
publisher = node.create_publisher(String, "chatter", 10)
heard = set()
node.create_subscription(String, "answers", lambda message: heard.add(message.data), 10)

publishing = threading.Event()
publishing.set()

def flood():
    while publishing.is_set():
        publisher.publish(String(data="from the parent"))
        time.sleep(0.0001)

def spin():
    try:
        rclpy.spin(node)
    except rclpy.executors.ExternalShutdownException:
        pass

threads = [threading.Thread(target=one, daemon=True) for one in (flood, spin)]
for thread in threads:
    thread.start()

def end():
    print("parent sees", node.get_node_names())
    publishing.clear()  # a publish() after shutdown() would raise
    threads[0].join()
    rclpy.shutdown()
    for thread in threads:
        thread.join()

def fork(work):
    pid = os.fork()
    if pid == 0:
        work()
        sys.exit(7)
    return os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])

def process(work):
    child = multiprocessing.get_context("fork").Process(target=work)
    child.start()
    child.join()
    return child.exitcode
"""

OWN_NODE = """
def work():
    {begin}
    own = Node("child")
    answers = own.create_publisher(String, "answers", 10)
    texts = []
    own.create_subscription(String, "chatter", lambda message: texts.append(message.data), 10)
    while not texts:
        rclpy.spin_once(own)
    answers.publish(String(data="from the child"))
    print("child heard", texts[0], flush=True)
    {end}
"""


@pytest.mark.parametrize(("way", "code"), [("process", 0), ("fork", 7)])
def test_forked_children_end_while_other_threads_of_the_parent_publish(
    start: Start, way: str, code: int
) -> None:
    program = start(
        source=f"""{PARENT}
def work():
    node.get_logger().debug("in the child")
print({{{way}(work) for _ in range(60)}})
end()
"""
    )
    assert program.wait(allowed(60)) == 0
    assert program.lines == [f"{{{code}}}", "parent sees ['parent']"]


#: Calls of a child, and whether they need the parent's session.
CALLS = (
    ("publisher.publish(String())", True),
    ("node.create_publisher(String, 'more', 10)", True),
    ("Node('second')", True),
    ("rclpy.spin_once(node)", True),
    ("rclpy.spin(node)", True),
    ("rclpy.executors.SingleThreadedExecutor().add_node(node)", True),
    ("rclpy.executors.MultiThreadedExecutor().spin()", True),
    ("node.get_topic_names_and_types()", True),
    ("node.count_subscribers('chatter')", True),
    ("client.wait_for_service()", True),
    ("client.call_async(Trigger.Request())", True),
    ("client.call(Trigger.Request())", True),
    ("rclpy.spin_until_future_complete(node, rclpy.task.Future())", True),
    ("node.get_logger().info('in the child')", False),
    ("node.get_clock().now()", False),
    ("node.destroy_publisher(publisher)", False),
    ("node.destroy_node()", False),
    ("rclpy.shutdown()", False),
    ("rclpy.ok() or 1 / 0", False),
)


_said: dict[str, list[str]] = {}


@pytest.fixture
def said(start: Start) -> dict[str, list[str]]:
    """Return what a child prints at each call. One parent starts all the children."""
    if not _said:
        program = start(
            source=f"""{PARENT}
from std_srvs.srv import Trigger
client = node.create_client(Trigger, "ask")

def work(call):
    try:
        exec(call)
    except RuntimeError as error:
        print(type(error).__name__, error, flush=True)

for call, _ in {CALLS}:
    print("--", call, flush=True)
    print("exit code", process(lambda: work(call)), flush=True)
end()
"""
        )
        assert program.wait(60) == 0
        for part in "\n".join(program.lines).split("-- ")[1:]:
            call, *lines = part.splitlines()
            _said[call] = lines
    return _said


@pytest.mark.parametrize(("call", "needs"), CALLS)
def test_a_child_that_needs_the_parents_session_gets_a_sentence(
    said: dict[str, list[str]], call: str, needs: bool
) -> None:
    lines = said[call]
    sentences = [line for line in lines if "ForkedProcessError" in line]
    assert [("call rclpy.init() here" in line and "spawn" in line) for line in sentences] == [
        True
    ] * needs
    assert "exit code 0" in lines


def test_the_children_leave_the_parents_node(said: dict[str, list[str]]) -> None:
    assert said[CALLS[-1][0]][-1] == "parent sees ['parent']"


@pytest.mark.parametrize("way", ["process", "fork"])
@pytest.mark.parametrize(
    ("begin", "end"),
    [
        ("rclpy.init()", "pass"),
        ("rclpy.init()", "own.destroy_node(); rclpy.shutdown()"),
        ("rclpy.shutdown(); rclpy.init()", "rclpy.shutdown()"),
        ("rclpy.init()", "raise SystemExit(7)"),
    ],
)
def test_a_child_may_have_a_node_of_its_own(start: Start, begin: str, end: str, way: str) -> None:
    program = start(
        source=f"""{PARENT}{OWN_NODE.format(begin=begin, end=end)}
print("exit code", {way}(work))
while not heard:
    time.sleep(0.01)
print(heard)
end()
"""
    )
    assert program.wait() == 0
    code = 7 if way == "fork" or "7" in end else 0
    expected = ["child heard from the parent", f"exit code {code}", "{'from the child'}"]
    assert program.lines[:3] == expected
    assert "'parent'" in program.lines[3]


def test_a_child_with_a_node_may_end_without_an_exit_function(start: Start) -> None:
    program = start(
        source=f"""{PARENT}{OWN_NODE.format(begin="rclpy.init()", end="os._exit(7)")}
print("exit code", process(work))
end()
"""
    )
    assert program.wait() == 0
    assert program.lines[:2] == ["child heard from the parent", "exit code 7"]


def test_a_child_of_a_child_may_have_a_node_too(start: Start) -> None:
    program = start(
        source=f"""{PARENT}{OWN_NODE.format(begin="rclpy.init()", end="pass")}
def twice():
    work()
    print("grandchild", process(work), flush=True)
print("child", process(twice))
end()
"""
    )
    assert program.wait() == 0
    assert program.lines.count("child heard from the parent") == 2
    assert {"grandchild 0", "child 0"} <= set(program.lines)


@pytest.mark.parametrize(
    ("number", "code"), [(signal.SIGTERM, -signal.SIGTERM), (signal.SIGINT, 1)]
)
def test_a_signal_ends_a_child_as_if_the_parent_had_no_node(
    start: Start, number: int, code: int
) -> None:
    program = start(
        source=f"""{PARENT}
def work():
    threading.Timer(0.01, signal.pthread_kill, [threading.main_thread().ident, {number}]).start()
    while rclpy.ok():
        time.sleep(60)
print("exit code", process(work))
end()
"""
    )
    assert program.wait() == 0
    assert program.lines[-2:] == [f"exit code {code}", "parent sees ['parent']"]


def test_the_child_of_a_callback_that_returns_to_spin_ends(start: Start) -> None:
    program = start(
        source="""
import os
import zbot
zbot.init()
node = zbot.Node("parent")

def work():
    pid = os.fork()
    if pid:
        print("exit code", os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]), flush=True)
        zbot.shutdown()

node.create_guard_condition(work).trigger()
zbot.spin(node)
""",
        by_zbot=True,
    )
    assert program.wait() == 0
    assert program.lines[-1] == "exit code 1"
    assert any(line.startswith("zbot.errors.ForkedProcessError: ") for line in program.lines)


WAYS = {
    "pool": """
from concurrent.futures import ProcessPoolExecutor
with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("fork")) as pool:
    print(sum(pool.map(abs, [-1, -2, -3])))
""",
    "preexec_fn": """
print(subprocess.run(["echo", "6"], preexec_fn=os.setsid, capture_output=True).stdout.decode()[0])
""",
    "terminal": """
import pty
pid, terminal = pty.fork()
if pid == 0:
    print("6")
    sys.exit(0)
print(os.read(terminal, 1).decode())
os.waitpid(pid, 0)
""",
    "daemon": """
reader, writer = os.pipe()
if os.fork() == 0:
    os.setsid()
    if os.fork():
        os._exit(0)
    rclpy.init()
    os.write(writer, str(5 + len(Node("daemon").get_name().split())).encode())
    sys.exit(0)
print(os.read(reader, 1).decode())
os.wait()
""",
    "callback": """
done = threading.Event()
def call():
    timer.cancel()
    print(6 + process(int))
    done.set()
timer = node.create_timer(0.01, call)
done.wait()
""",
}


@pytest.mark.parametrize("way", WAYS)
def test_a_program_with_a_node_may_start_processes_in_every_way(start: Start, way: str) -> None:
    program = start(source=PARENT + WAYS[way] + "\nend()\n")
    assert program.wait() == 0
    assert program.lines[0] == "6"
    assert "'parent'" in program.lines[1]


@pytest.mark.parametrize("begin", ["pass", "zbot.init()"])
def test_the_fork_of_a_program_without_a_node_may_have_nodes(start: Start, begin: str) -> None:
    program = start(
        source=f"""
import multiprocessing
import zbot

def work():
    {begin}
    print(zbot.Node("child").get_node_names())

zbot.init()
child = multiprocessing.get_context("fork").Process(target=work)
child.start()
child.join()
print(child.exitcode, zbot.Node("parent").get_name())
"""
    )
    assert program.wait() == 0
    assert program.lines == ["['child']", "0 parent"]


def test_the_fork_of_a_program_without_a_session_uses_the_same_library(start: Start) -> None:
    program = start(
        source="""
import multiprocessing
import zbot, zenoh

def work():
    before = zenoh.open
    print(zbot.Node("child").get_node_names(), zenoh.open is before)

zbot.init()
child = multiprocessing.get_context("fork").Process(target=work)
child.start()
child.join()
print(child.exitcode)
"""
    )
    assert program.wait() == 0
    assert program.lines == ["['child'] True", "0"]
