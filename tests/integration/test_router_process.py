"""Tests of the router process: its start, its end, and its replacement if it does not answer."""

from __future__ import annotations

import contextlib
import errno
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from types import SimpleNamespace
from typing import TYPE_CHECKING

import pytest
import zenoh

import zbot
from tests.classroom.talk import free_port
from tests.cli.command import zbot as zbot_command
from tests.conftest import allowed, wait_until
from zbot.transport import admin_query, background_process, config, router_process, session
from zbot.transport.peering import Peering
from zbot.transport.process_facts import process_facts
from zbot.transport.router_process import IdleWatch, is_stopped
from zbot.transport.session import MeetingPoint

from std_msgs.msg import Int64, String

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from tests.conftest import MakeContext, Program, Spin, Start
    from zbot.log.record import Record

pytestmark = [
    pytest.mark.own_dialect("ROS 2 has a router that the user starts, and no meeting port"),
    pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals"),
]

NODES = 4

TALKER = """
import sys, zbot
from std_msgs.msg import String

with zbot.init():
    node = zbot.Node(sys.argv[1])
    publisher = node.create_publisher(String, "chatter", 10)
    node.create_timer(0.01, lambda: publisher.publish(String(data=sys.argv[1])))
    print("ready", flush=True)
    zbot.spin(node)
"""

# Links programs, but answers nothing and uses no processor, like a router in a deadlock.
SILENT_ROUTER = """
import json, os, sys, threading, zenoh
from zbot.transport import background_process, membership


domain = int(os.environ["ZBOT_DOMAIN_ID"])
membership.folder().mkdir(parents=True, exist_ok=True)
file = background_process.lock_path(f"router-{domain}").open("w")
assert background_process.lock(file)
print(os.getpid(), end="", file=file, flush=True)
config = zenoh.Config()
settings = {
    "mode": "router",
    "listen/endpoints": [f"tcp/127.0.0.1:{7450 + domain}"],
    "scouting/multicast/enabled": False,
    "adminspace/enabled": False,
}
for path, value in settings.items():
    config.insert_json5(path, json.dumps(value))
session = zenoh.open(config)
print("ready", flush=True)
threading.Event().wait()
"""


@pytest.fixture
def domain(free_domain: int) -> int:
    """Return a domain whose router is a process, as outside of tests."""
    return free_domain


@pytest.fixture
def talkers(start: Start) -> list[Program]:
    programs = [start(f"talker_{number}", source=TALKER) for number in range(NODES)]
    for program in programs:
        program.wait_for("ready")
    return programs


@pytest.fixture
def heard(make_context: MakeContext, spin: Spin) -> Callable[[], set[str]]:
    """Return a function that makes a node, and returns the talkers that it heard."""

    def listen() -> set[str]:
        names = set[str]()
        node = zbot.Node("listener", context=make_context())
        node.create_subscription(String, "chatter", lambda message: names.add(message.data), 10)
        spin(node)
        wait_until(lambda: len(names) == NODES, 3)
        return names

    return listen


def router_of(domain: int) -> int:
    number = router_process.pid(domain)
    assert number is not None
    return number


def listed() -> list[str]:
    done = zbot_command("node", "list")
    assert done.code == 0
    return sorted(done.out.split())


WANTED = {f"talker_{number}" for number in range(NODES)}


@pytest.mark.parametrize("number", [signal.SIGSTOP, signal.SIGKILL, signal.SIGTERM])
def test_a_new_node_hears_all_nodes_when_the_router_is_gone(
    talkers: list[Program], domain: int, heard: Callable[[], set[str]], number: int
) -> None:
    os.kill(router_of(domain), number)
    assert heard() == WANTED
    assert all(talker.process.poll() is None for talker in talkers)


@pytest.mark.usefixtures("talkers")
@pytest.mark.parametrize("number", [signal.SIGSTOP, signal.SIGKILL, signal.SIGTERM])
def test_a_command_lists_all_nodes_when_the_router_is_gone(domain: int, number: int) -> None:
    os.kill(router_of(domain), number)
    assert wait_until(lambda: listed() == sorted(f"/{name}" for name in WANTED))


@pytest.mark.usefixtures("talkers")
def test_the_warning_names_the_stopped_router(
    domain: int, make_context: MakeContext, logged: list[Record]
) -> None:
    stopped = router_of(domain)
    os.kill(stopped, signal.SIGSTOP)
    zbot.Node("newcomer", context=make_context())
    (line,) = (record.message for record in logged if record.name == "zbot")
    assert line.startswith(f"the router of domain {domain} (process {stopped}) did not answer")
    assert router_of(domain) != stopped


def test_a_check_ends_a_stopped_router_without_a_question(
    domain: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    point = MeetingPoint(config.load(), domain, config.discovery_range(), process_facts("0"))
    point.start_router()
    opened = point.open_node_session()
    peering = Peering(opened, point, zenoh.handlers.Callback)
    assert peering.wait_for_router(allowed(5))
    stopped = router_of(domain)
    os.kill(stopped, signal.SIGSTOP)
    assert wait_until(lambda: is_stopped(stopped))
    asked: list[float] = []
    monkeypatch.setattr(admin_query, "sessions", lambda *words: asked.append(words[-1]))
    assert peering._check() is not None
    assert router_process.pid(domain) is None
    assert asked == []  # it would wait a second for an answer
    opened.close()
    point.close()


def test_a_router_that_was_just_killed_is_no_foreign_program(domain: int) -> None:
    """Another program has noted the kill, and the process has not closed the port yet."""
    point = MeetingPoint(config.load(), domain, config.discovery_range(), process_facts("0"))
    point.start_router()
    assert wait_until(lambda: router_process.pid(domain) is not None and point.is_taken())
    path = background_process.lock_path(f"router-{domain}")
    number = path.read_text(encoding="utf-8")
    try:
        path.write_text("killed", encoding="utf-8")
        assert not point.is_foreign()
        before_s = time.time() - 2
        os.utime(path, (before_s, before_s))
        assert point.is_foreign()
    finally:
        path.write_text(number, encoding="utf-8")
        point.close()


def test_a_router_that_answers_nothing_is_replaced_by_a_command(start: Start, domain: int) -> None:
    start(source=SILENT_ROUTER).wait_for("ready")
    silent = router_of(domain)
    assert listed() == []
    assert router_of(domain) != silent


def test_a_router_that_answers_nothing_is_replaced_by_a_node(
    start: Start, domain: int, make_context: MakeContext
) -> None:
    start(source=SILENT_ROUTER).wait_for("ready")
    silent = router_of(domain)
    zbot.Node("first", context=make_context())
    assert wait_until(lambda: router_process.pid(domain) not in {silent, None}, 8)
    second = zbot.Node("second", context=make_context())
    assert wait_until(lambda: second.get_node_names() == ["first", "second"])


def test_nothing_is_lost_while_the_router_is_replaced(
    domain: int, make_context: MakeContext, spin: Spin
) -> None:
    talker, listener = (zbot.Node(name, context=make_context()) for name in ("talker", "listener"))
    numbers: list[int] = []
    listener.create_subscription(Int64, "count", lambda message: numbers.append(message.data), 1000)
    publisher = talker.create_publisher(Int64, "count", 1000)
    assert wait_until(lambda: publisher.get_subscription_count() == 1)
    spin(listener)
    for number in range(500):
        if number == 100:
            os.kill(router_of(domain), signal.SIGKILL)
        publisher.publish(Int64(data=number))
    assert wait_until(lambda: len(numbers) == 500)
    assert numbers == list(range(500))
    assert wait_until(lambda: router_process.pid(domain) is not None)


@pytest.mark.skipif(not Path("/proc").is_dir(), reason="needs Linux's list of processes")
def test_a_killed_router_does_not_stay_as_a_zombie(domain: int, make_context: MakeContext) -> None:
    zbot.Node("only", context=make_context())
    killed = router_of(domain)
    os.kill(killed, signal.SIGKILL)
    assert wait_until(lambda: router_process.pid(domain) not in {killed, None})
    assert wait_until(lambda: not Path(f"/proc/{killed}").exists())


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() != 0, reason="mounting needs root")
def test_one_router_starts_if_the_disk_is_full(
    free_domain: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    words = ["mount", "-t", "tmpfs", "-o", "size=64k", "zbot-test", str(tmp_path)]
    if subprocess.run(words, check=False, capture_output=True).returncode:
        pytest.skip("this system refuses to mount a small file system")
    started: list[int] = []

    def note(domain: int, *_: object, **__: object) -> object:
        started.append(domain)
        return SimpleNamespace(pid=12345)

    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    monkeypatch.setattr(router_process, "_start", note)
    try:
        ballast = (tmp_path / "ballast").open("wb", buffering=0)
        with ballast, contextlib.suppress(OSError):
            while ballast.write(bytes(4096)):
                continue
        assert router_process.start(free_domain)
        assert started == [free_domain]
        (tmp_path / "ballast").unlink()
        router_process.note_end(free_domain)
        assert router_process.start(free_domain)
        assert router_process._read(free_domain) == "12345"
    finally:
        subprocess.run(["umount", str(tmp_path)], check=True)


def test_programs_that_start_together_start_one_router(start: Start, domain: int) -> None:
    programs = [start(f"talker_{number}", source=TALKER) for number in range(8)]
    for program in programs:
        program.wait_for("ready")
    words = f"zbot.transport\0{domain}\0".encode()
    assert sum(line.endswith(words) for line in command_lines()) == 1


def command_lines() -> Iterator[bytes]:
    for path in Path("/proc").glob("[0-9]*/cmdline"):
        with contextlib.suppress(OSError):  # the process has ended
            yield path.read_bytes()


def test_ctrl_c_in_a_terminal_does_not_reach_the_router(start: Start, domain: int) -> None:
    first = start("setsid", sys.executable, "-c", TALKER, "first")
    first.wait_for("ready")
    router = router_of(domain)
    second = start("second", source=TALKER)
    second.wait_for("ready")
    os.killpg(first.process.pid, signal.SIGINT)
    first.wait()
    assert router_of(domain) == router
    assert wait_until(lambda: listed() == ["/second"])


BUSY = "print('ready', flush=True)\nwhile True: pass"
WAITING = "import threading\nprint('ready', flush=True)\nthreading.Event().wait()"


@pytest.mark.parametrize(
    ("source", "number", "state"),
    [(BUSY, 0, (False, False)), (WAITING, 0, (False, True)), (BUSY, signal.SIGSTOP, (True, True))],
    ids=["busy", "waiting", "stopped"],
)
def test_the_state_of_a_process_is_known(
    start: Start, source: str, number: int, state: tuple[bool, bool]
) -> None:
    program = start(source=source)
    program.wait_for("ready")
    process = program.process.pid
    os.kill(process, number)
    assert wait_until(lambda: (is_stopped(process), IdleWatch(process).is_idle(0.3)) == state)


def test_a_router_that_works_is_not_killed(domain: int, make_context: MakeContext) -> None:
    context = make_context()
    zbot.Node("only", context=context)
    meeting = MeetingPoint(config.load(), domain, config.discovery_range(), {})
    router = router_of(domain)
    assert not meeting.end_stuck_router()
    assert router_of(domain) == router


def test_a_program_that_is_slow_itself_does_not_kill_the_router(
    domain: int, make_context: MakeContext, monkeypatch: pytest.MonkeyPatch
) -> None:
    zbot.Node("only", context=make_context())
    meeting = MeetingPoint(config.load(), domain, config.discovery_range(), {})
    router = router_of(domain)
    answers = iter([False, True])  # the first answer is heard too late
    monkeypatch.setattr(router_process, "is_machine_busy", lambda *_: True)
    monkeypatch.setattr(router_process, "age_s", lambda _: 60.0)
    monkeypatch.setattr(MeetingPoint, "_answers", lambda *_, **_patient: next(answers))
    monkeypatch.setattr(IdleWatch, "is_idle", lambda *_: True)
    assert not meeting.end_stuck_router()
    assert router_of(domain) == router
    assert next(answers, None) is None


def test_a_router_is_started_as_soon_as_there_are_descriptors_again(
    domain: int, make_context: MakeContext, monkeypatch: pytest.MonkeyPatch
) -> None:
    zbot.Node("only", context=make_context())
    start_router, errors = MeetingPoint.start_router, [OSError(errno.EMFILE, "Too many open files")]

    def start(meeting: MeetingPoint) -> bool:
        if errors:
            raise errors.pop()
        return start_router(meeting)

    monkeypatch.setattr(MeetingPoint, "start_router", start)
    router = router_of(domain)
    os.kill(router, signal.SIGKILL)
    assert wait_until(lambda: router_process.pid(domain) not in {router, None})
    assert not errors


def test_nodes_do_not_give_up_a_dial_early(domain: int, monkeypatch: pytest.MonkeyPatch) -> None:
    # A dial that is given up can leave a link that never reads (docs/design/zenoh-faults.md).
    opened: list[zenoh.Config] = []
    monkeypatch.setattr(session, "open_session", lambda _, given: opened.append(given))
    meeting = MeetingPoint(config.load(), domain, config.discovery_range(), {})
    meeting.open_node_session()
    meeting.close()
    assert int(opened[0].get_json("transport/unicast/open_timeout")) >= 5000


def opened(mode: str, *ports: int) -> zenoh.Session:
    """Open a plain Zenoh session that is linked to the given ports."""
    settings = zenoh.Config()
    for name, value in {
        "mode": mode,
        "listen/endpoints": ["tcp/127.0.0.1:0"],
        "connect/endpoints": [f"tcp/127.0.0.1:{port}" for port in ports],
        "scouting/multicast/enabled": False,
    }.items():
        settings.insert_json5(name, json.dumps(value))
    return zenoh.open(settings)


def test_a_router_passes_on_the_tokens_of_programs_that_know_a_former_router(
    free_domain: int,
) -> None:
    reach = config.discovery_range()
    points = [MeetingPoint(config.load(), free_domain, reach, {}) for _ in range(2)]
    points[1].port = free_port()
    former, router = (point.open_router() for point in points)
    assert former
    assert router
    ids = [bytes.fromhex(str(session.info.zid()))[::-1] for session in (former, router)]
    assert ids == sorted(ids)
    with router, opened("peer", *(point.port for point in points)) as peer:
        assert wait_until(lambda: len(peer.info.routers_zid()) == 2)
        with opened("router", points[1].port) as hub, peer.liveliness().declare_token("token"):
            former.close()
            get = hub.liveliness().get
            assert wait_until(lambda: any(reply.ok for reply in get("token", timeout=1.0)))
