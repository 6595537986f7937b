"""Tests of zbot in somebody else's process: it leaves the process as it was."""

from __future__ import annotations

import signal
import sys
from typing import TYPE_CHECKING

import pytest

from tests.integration.process.conftest import stop_without_errors

if TYPE_CHECKING:
    from tests.conftest import Start

#: Prints what differs in the process before the import of zbot, with a node, and after its end.
GUEST = """
import asyncio, collections, concurrent.futures, gc, os, signal, sys, threading, traceback, warnings

def state():
    return {
        "excepthook": sys.excepthook,
        "threading.excepthook": threading.excepthook,
        "unraisablehook": sys.unraisablehook,
        "displayhook": sys.displayhook,
        "breakpointhook": sys.breakpointhook,
        "print_exception": traceback.print_exception,
        "showwarning": warnings.showwarning,
        "trace": (sys.gettrace(), sys.getprofile(), threading.gettrace(), threading.getprofile()),
        "frozen objects": gc.get_freeze_count(),
        "collector": (gc.isenabled(), gc.get_threshold(), len(gc.callbacks)),
        "switch interval": sys.getswitchinterval(),
        "recursion limit": sys.getrecursionlimit(),
        "event loop policy": type(event_loop_policy()),
        "wake-up descriptor": wakeup_descriptor(),
    }

def event_loop_policy():
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # since Python 3.14
        return asyncio.get_event_loop_policy()

def resources():
    return {
        "signals": {one: signal.getsignal(one) for one in signal.valid_signals()},
        "threads": sorted(thread.name for thread in threading.enumerate()),
        "descriptors": sorted(descriptors()),
        "directory": os.getcwd(),
        "environment": dict(os.environ),
        "arguments": list(sys.argv),
    }

def wakeup_descriptor():
    present = signal.set_wakeup_fd(-1)
    signal.set_wakeup_fd(present)
    return present

def descriptors():
    for name in os.listdir("/proc/self/fd"):
        try:
            target = os.readlink(f"/proc/self/fd/{name}")
        except OSError:
            continue  # the descriptor of the listing itself
        # Zenoh 1.10 never frees a session that has an admin space, and its file stays open. libffi
        # keeps its own file open when a C library gets a Python function for the first time.
        if not target.endswith(".zenoh") and "/libffi.so" not in target:
            yield target.split(":")[0]

def compare(when, old, new):
    for name, value in old.items():
        if new[name] != value:
            print(f"{when}: {name}: {value} -> {new[name]}")

def use_a_node():
    zbot.init()
    node = zbot.Node("guest")
    heard = []
    qos = zbot.QoSProfile(depth=10, history=zbot.HistoryPolicy.{history})
    publisher = node.create_publisher(String, "chatter", qos)
    node.create_subscription(String, "chatter", heard.append, qos)
    publisher.publish(String(data="hello"))
    while not heard:
        zbot.spin_once(node)
    if "{history}" == "KEEP_LAST":
        compare("node", own, state())
    zbot.shutdown()
    print("heard", heard[0].data)

# A process that has hooks of its own keeps them.
sys.excepthook = lambda *error: sys.__excepthook__(*error)
threading.excepthook = lambda error: threading.__excepthook__(error)
own, had = state(), resources()
import zbot
from std_msgs.msg import String

compare("import", own | had, state() | resources())
use_a_node()
compare("shutdown", own, state())
once = resources()
# Zenoh's runtime keeps its event queues and a pair of sockets for the next session.
kept = {"anon_inode", "socket"}
compare("shutdown", had, once | {"descriptors": [x for x in once["descriptors"] if x not in kept]})
use_a_node()
twice = resources()
# Sockets of the first session may have been closed only now.
more = collections.Counter(twice["descriptors"]) - collections.Counter(once["descriptors"])
twice["descriptors"] = list(more)
compare("second shutdown", own | once | {"descriptors": []}, state() | twice)
"""

PYTEST_OF_A_USER = """
import pytest, zbot
from std_msgs.msg import String

# As for each installed plugin.
pytest.register_assert_rewrite("zbot", "zbot_ros2_names", "zbot_name_clash")

@pytest.fixture
def node():
    zbot.init()
    node = zbot.Node("tested")
    yield node
    node.destroy_node()
    zbot.shutdown()

@pytest.mark.parametrize("turn", range(3))
def test_a_message_arrives(node, turn):
    heard = []
    node.create_subscription(String, "chatter", heard.append, 10)
    node.create_publisher(String, "chatter", 10).publish(String(data=str(turn)))
    while not heard:
        zbot.spin_once(node, timeout_sec=1)
    assert heard[0].data == str(turn)

if __name__ == "__main__":
    raise SystemExit(pytest.main(["-q", "-W", "error", "-p", "no:cacheprovider", __file__]))
"""

SPINNING_THREAD = """
import threading, time, zbot
zbot.init()
node = zbot.Node("robot")
node.create_guard_condition(lambda: print("up", flush=True)).trigger()

def work():
    {loop}

threading.Thread(target=work, daemon=True).start()
while True:
    time.sleep(0.2)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="lists descriptors in /proc")
@pytest.mark.parametrize("history", ["KEEP_LAST", "KEEP_ALL"])
def test_a_node_changes_nothing_in_its_process(start: Start, history: str) -> None:
    program = start(source=GUEST.replace("{history}", history))
    assert program.wait() == 0
    assert program.lines == ["heard hello", "heard hello"]


def test_nodes_work_in_the_pytest_of_a_user(start: Start) -> None:
    program = start(source=PYTEST_OF_A_USER)
    assert program.wait() == 0, program.output
    assert "3 passed" in program.output


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
@pytest.mark.parametrize("loop", ["zbot.spin(node)", "while True: zbot.spin_once(node)"])
def test_ctrl_c_prints_nothing_of_a_thread_that_spins(start: Start, loop: str) -> None:
    program = start(source=SPINNING_THREAD.replace("{loop}", loop), by_zbot=True)
    program.wait_for("up")
    assert stop_without_errors(program, signal.SIGINT) == -signal.SIGINT
    assert program.lines == ["up"]


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
def test_threads_that_publish_while_the_process_ends_print_nothing(start: Start) -> None:
    # Zenoh would abort the process if Python killed a thread inside a put.
    program = start(
        source="""
import threading, zbot
from std_msgs.msg import String
zbot.init()
node = zbot.Node("robot")
publisher = node.create_publisher(String, "chatter", 10)
started = threading.Event()

def flood():
    while True:
        publisher.publish(String(data="hello"))
        started.set()

for _ in range(4):
    threading.Thread(target=flood, daemon=True).start()
started.wait()
"""
    )
    assert program.wait() == 0
    assert not program.output
