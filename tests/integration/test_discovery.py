"""Tests of discovery between processes and of the messages about its failures."""

from __future__ import annotations

import itertools
import signal
import socket
import sys
import threading
from contextlib import contextmanager, nullcontext
from typing import TYPE_CHECKING

import pytest

import zbot
from tests.conftest import allowed, wait_until
from zbot.testing.domain import open_router
from zbot.transport.config import MEETING_PORT
from zbot.transport.session import MeetingPoint
from zbot_cli.domain.client import client

from std_msgs.msg import String

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    import zenoh

    from tests.conftest import MakeContext, Spin, Start

pytestmark = pytest.mark.own_dialect("ROS 2 has a router that the user starts, and no meeting port")

needs_sigkill = pytest.mark.skipif(sys.platform == "win32", reason="Windows has no SIGKILL")

IDLE = """
import sys, zbot

with zbot.init():
    node = zbot.Node(sys.argv[1])
    print("ready", flush=True)
    zbot.spin(node)
"""

TALKER = """
import zbot
from std_msgs.msg import String

with zbot.init():
    node = zbot.Node("talker")
    publisher = node.create_publisher(String, "chatter", 10)
    node.create_timer(0.01, lambda: publisher.publish(String(data="hello")))
    zbot.spin(node)
"""

LISTENER = """
import zbot
from std_msgs.msg import String


with zbot.init():
    node = zbot.Node("listener")
    node.create_subscription(String, "chatter", lambda message: print("heard"), 10)
    print("ready")
    zbot.spin(node)
"""

# Publishes at once and ends its context, three times.
SHORT = """
import sys, zbot
from std_msgs.msg import String

for turn in range(3):
    with zbot.init():
        publisher = zbot.Node(f"short_{sys.argv[1]}").create_publisher(String, "chatter", 10)
        publisher.publish(String(data=f"{sys.argv[1]}.{turn}"))
"""

SINGLE = """
import zbot
from std_msgs.msg import String

with zbot.init():
    node = zbot.Node("single")
    node.create_subscription(String, "chatter", lambda message: print("heard", message.data), 10)
    node.create_publisher(String, "chatter", 10).publish(String(data="myself"))
    zbot.spin(node)
"""

START = """
import zbot

with zbot.init():
    zbot.Node("never")
print("no error")
"""


@pytest.fixture
def domain(free_domain: int) -> int:
    """Return a domain whose router is a process, as outside of tests."""
    return free_domain


def holds_port(domain: int) -> bool:
    with socket.socket() as probe:
        return probe.connect_ex(("127.0.0.1", MEETING_PORT + domain)) == 0


# -- the meeting port ------------------------------------------------------------------------------


@needs_sigkill
def test_other_processes_communicate_and_join_after_the_holder_is_killed(start: Start) -> None:
    holder = start("holder", source=IDLE)
    holder.wait_for("ready")
    listener = start(source=LISTENER)
    talker = start(source=TALKER)
    listener.wait_for("heard")
    holder.stop(signal.SIGKILL)
    for _ in range(20):
        listener.wait_for("heard", timeout=2)
    newcomer = start(source=LISTENER)
    newcomer.wait_for("ready")
    newcomer.wait_for("heard", timeout=2)
    assert talker.process.poll() is None


@needs_sigkill
def test_the_port_is_taken_over_again_and_again(
    start: Start, domain: int, make_context: MakeContext
) -> None:
    holder = start("first", source=IDLE)
    holder.wait_for("ready")
    survivor = zbot.Node("survivor", context=make_context())
    for turn in range(3):
        holder.stop(signal.SIGKILL)
        assert wait_until(lambda: holds_port(domain), timeout_s=2)
        holder = start(f"holder_{turn}", source=IDLE)
        holder.wait_for("ready")
        assert survivor.wait_for_node(f"/holder_{turn}", timeout=allowed(2))
    assert wait_until(lambda: sorted(survivor.get_node_names()) == ["holder_2", "survivor"])


def test_a_context_that_ends_hands_the_port_over(
    make_context: MakeContext, domain: int, spin: Spin
) -> None:
    contexts = [make_context() for _ in range(4)]
    nodes = [zbot.Node(f"node_{k}", context=context) for k, context in enumerate(contexts)]
    inbox: list[String] = []
    nodes[3].create_subscription(String, "chatter", inbox.append, 10)
    spin(nodes[3])
    for context in contexts[:3]:
        context.shutdown()
        newcomer = zbot.Node("newcomer", context=make_context())
        publisher = newcomer.create_publisher(String, "chatter", 10)
        inbox.clear()

        def is_heard(publisher: zbot.Publisher[String] = publisher) -> bool:
            publisher.publish(String())
            return bool(inbox)

        assert wait_until(is_heard, timeout_s=2)
        assert holds_port(domain)
        newcomer.context.shutdown()


def test_the_router_ends_after_the_last_program(make_context: MakeContext, domain: int) -> None:
    context = make_context()
    zbot.Node("only", context=context)
    assert holds_port(domain)
    context.shutdown()
    assert wait_until(lambda: not holds_port(domain))


@needs_sigkill
def test_two_processes_that_missed_their_connections_are_introduced_again(
    start: Start, make_context: MakeContext
) -> None:
    zbot.Node("acquaintance", context=make_context())
    listener = start(source=LISTENER)
    listener.wait_for("ready")
    # Zenoh gives up a connection after 0.5 s: each process is stopped while the other one tries.
    listener.process.send_signal(signal.SIGSTOP)
    talker = start(source=TALKER)
    threading.Event().wait(allowed(1.5))
    talker.process.send_signal(signal.SIGSTOP)
    listener.process.send_signal(signal.SIGCONT)
    threading.Event().wait(1.5)
    talker.process.send_signal(signal.SIGCONT)
    listener.wait_for("heard")


def test_a_command_asks_the_router_of_another_user_again(
    domain: int, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    router = open_router(domain, monkeypatch)  # it is not in the files of this user's routers
    assert router is not None
    open_client = MeetingPoint._open_client

    def open_late(
        point: MeetingPoint, endpoint: str, *, is_patient: bool = False
    ) -> zenoh.Session | None:
        return open_client(point, endpoint, is_patient=True) if is_patient else None

    monkeypatch.setattr(MeetingPoint, "_open_client", open_late)
    with zbot.Context(mode="client") as context:
        assert context.get_domain_id() == domain
        assert context.connect()
    assert "nobody answers" not in capsys.readouterr().err
    router.close()


def test_a_context_without_a_node_opens_no_port(make_context: MakeContext, domain: int) -> None:
    make_context()
    assert not holds_port(domain)


# -- joining ---------------------------------------------------------------------------------------


def test_the_first_messages_of_thirty_short_programs_arrive(
    start: Start, make_context: MakeContext, spin: Spin
) -> None:
    listener = zbot.Node("listener", context=make_context())
    heard: list[str] = []
    listener.create_subscription(String, "chatter", lambda message: heard.append(message.data), 100)
    spin(listener)
    for number in range(10):
        program = start(str(number), source=SHORT)
        assert (program.wait(), program.output) == (0, "")
    wanted = sorted(f"{number}.{turn}" for number in range(10) for turn in range(3))
    wait_until(lambda: len(heard) >= 30)
    assert sorted(heard) == wanted


def test_twelve_programs_started_together_see_each_other(
    start: Start, domain: int, make_context: MakeContext
) -> None:
    programs = [start(f"node_{number}", source=IDLE) for number in range(12)]
    for program in programs:
        program.wait_for("ready")
    wanted = sorted(f"node_{number}" for number in range(12))
    with zbot.Context(mode="client") as client:
        assert client.get_domain_id() == domain
        assert client.connect()
        assert sorted(token.node for token in client.graph.snapshot().nodes) == wanted
    newcomer = zbot.Node("zz_newcomer", context=make_context())
    # A link that failed on a busy machine is made again after 1 to 2 s.
    newcomer.context.graph.wait_for(lambda graph: len(graph.nodes) == 13, allowed(5))
    assert sorted(newcomer.get_node_names()) == [*wanted, "zz_newcomer"]
    for program in programs:
        program.process.send_signal(signal.SIGINT)
    for program in programs:
        program.wait()
        assert program.output == "ready"


def test_a_client_without_peers_does_not_connect_and_opens_no_port(domain: int) -> None:
    with zbot.Context(mode="client") as client:
        assert client.get_domain_id() == domain
        assert not client.connect()
        assert not holds_port(domain)


def test_a_waiting_client_is_found_by_later_nodes(domain: int, make_context: MakeContext) -> None:
    with zbot.Context(mode="client") as client:
        assert client.get_domain_id() == domain
        assert client.connect(wait=True)
        zbot_node = zbot.Node("late", context=make_context())
        assert client.graph.wait_for(lambda graph: len(graph.nodes) == 1, allowed(2))
        assert zbot_node.get_name() == client.graph.snapshot().nodes[0].node


# -- failures ------------------------------------------------------------------------


@contextmanager
def foreign_program(domain: int, *, answer: bytes = b"") -> Iterator[None]:
    """Occupy the meeting port as a program that is not zbot."""
    accepted: list[socket.socket] = []
    server = socket.create_server(("127.0.0.1", MEETING_PORT + domain))

    def serve() -> None:
        while True:
            try:
                connection, _ = server.accept()
            except OSError:
                return
            accepted.append(connection)
            if answer:
                connection.sendall(answer)
                connection.close()

    thread = threading.Thread(target=serve)
    thread.start()
    try:
        yield
    finally:
        server.shutdown(socket.SHUT_RDWR)
        server.close()
        for connection in accepted:
            connection.close()
        thread.join(5)


@pytest.mark.parametrize("mode", ["peer", "client"])
def test_a_port_that_was_refused_to_all_is_taken_at_the_next_attempt(
    make_context: MakeContext, monkeypatch: pytest.MonkeyPatch, domain: int, mode: str
) -> None:
    # Linux refuses a port to both of two processes that bind it in the same microseconds.
    start_router, tries = MeetingPoint.start_router, itertools.count()
    monkeypatch.setattr(
        MeetingPoint, "start_router", lambda point: next(tries) > 0 and start_router(point)
    )
    if mode == "client":
        with client(wait=True) as context:
            assert not context.is_closed
            assert holds_port(domain)
        return
    first = zbot.Node("first", context=make_context())
    assert holds_port(domain)
    second = zbot.Node("second", context=make_context())
    assert wait_until(lambda: second.get_node_names() == ["first", "second"])
    assert wait_until(lambda: first.get_node_names() == ["first", "second"])


@pytest.mark.parametrize("answer", [b"", b"HTTP/1.1 400 Bad Request\r\n\r\n"])
def test_a_foreign_program_on_the_port_is_one_warning_and_the_node_runs(
    start: Start, domain: int, answer: bytes
) -> None:
    with foreign_program(domain, answer=answer):
        program = start(source=SINGLE)
        program.wait_for(f"nobody answers as zbot on tcp/127.0.0.1:{MEETING_PORT + domain}")
        program.wait_for("heard myself")
        program.stop()
        assert len(program.lines) == 2
        assert "choose another domain, e.g. ZBOT_DOMAIN_ID=7" in program.lines[0]


@pytest.mark.parametrize("lacks", ["discovery", "port"])
def test_a_command_without_a_router_subscribes_all_the_same(
    start: Start, monkeypatch: pytest.MonkeyPatch, domain: int, lacks: str
) -> None:
    monkeypatch.setenv("ZBOT_DISCOVERY_RANGE", "OFF" if lacks == "discovery" else "LOCALHOST")
    with foreign_program(domain) if lacks == "port" else nullcontext():
        program = start("zbot", "topic", "echo", "/x", "--timeout", "1")
        assert program.wait(30) == 1
    assert program.lines[-1] == "no message on /x within 1 s"


def test_range_off_finds_no_peers_and_opens_no_port(
    make_context: MakeContext, monkeypatch: pytest.MonkeyPatch, domain: int
) -> None:
    zbot.Node("public", context=make_context())
    # Nobody answers a hermit.
    monkeypatch.setattr("zbot.context.domain_session._DISCOVERY_TIMEOUT_S", 0.5)
    monkeypatch.setenv("ZBOT_DISCOVERY_RANGE", "OFF")
    hermit = zbot.Node("hermit", context=make_context())
    assert hermit.get_node_names() == ["hermit"]
    monkeypatch.delenv("ZBOT_DISCOVERY_RANGE")
    assert "hermit" not in zbot.Node("second", context=make_context()).get_node_names()
    assert holds_port(domain)


def test_range_off_communicates_inside_the_process(
    make_context: MakeContext, monkeypatch: pytest.MonkeyPatch, domain: int, spin: Spin
) -> None:
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "off")
    node = zbot.Node("hermit", context=make_context())
    assert not holds_port(domain)
    inbox: list[String] = []
    node.create_subscription(String, "chatter", inbox.append, 10)
    node.create_publisher(String, "chatter", 10).publish(String(data="self"))
    spin(node)
    assert wait_until(lambda: bool(inbox))


@pytest.mark.parametrize(
    ("variables", "sentence"),
    [
        ({"ZBOT_DOMAIN_ID": "233"}, "ZBOT_DOMAIN_ID is '233', but a domain is a whole number"),
        ({"ZBOT_DOMAIN_ID": "-1"}, "ZBOT_DOMAIN_ID is '-1'"),
        ({"ZBOT_DOMAIN_ID": "seven"}, "ZBOT_DOMAIN_ID is 'seven'"),
        ({"ZBOT_DOMAIN_ID": "", "ROS_DOMAIN_ID": "1e3"}, "ROS_DOMAIN_ID is '1e3'"),
        ({"ZBOT_DISCOVERY_RANGE": "WORLD"}, "use LOCALHOST, SUBNET or OFF"),
        ({"ZBOT_CONFIG": "nowhere.json5"}, "nowhere.json5: No such file or directory"),
        ({"ZENOH_CONFIG": "."}, "cannot use the Zenoh configuration .: Is a directory"),
    ],
)
def test_an_invalid_variable_is_refused_with_one_sentence(
    start: Start, variables: dict[str, str], sentence: str
) -> None:
    program = start(source=START, env=variables, by_zbot=True)
    assert program.wait() == 1
    assert len(program.lines) == 1
    assert sentence in program.output


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        (b"{ mode: ", "cannot use the Zenoh configuration zenoh.json5: "),
        (b"not a configuration", "cannot use the Zenoh configuration zenoh.json5: "),
        (b"\xff\xfe\x00", "cannot use the Zenoh configuration zenoh.json5: "),
        (b'{ mode: "captain" }', "captain"),
        (b'{ listen: { endpoints: ["pigeon/1"] } }', "pigeon"),
        (b"{ unknown_option: 1 }", "unknown_option"),
        (b'{ listen: { endpoints: ["tcp/192.0.2.1:1"] } }', "192.0.2.1"),
    ],
)
def test_an_invalid_configuration_file_is_refused_with_one_sentence(
    start: Start, tmp_path: Path, content: bytes, sentence: str
) -> None:
    (tmp_path / "zenoh.json5").write_bytes(content)
    program = start(source=START, by_zbot=True)
    assert program.wait() == 1
    assert sentence in program.output
    assert len(program.lines) == 1


def test_a_valid_configuration_file_is_used(start: Start, tmp_path: Path, domain: int) -> None:
    (tmp_path / "zenoh.json5").write_text('{ metadata: { room: "B 12" }, /* a comment */ }')
    program = start("named", source=IDLE)
    program.wait_for("ready")
    with zbot.Context(mode="client") as client:
        assert client.get_domain_id() == domain
        assert client.connect()
        (token,) = client.graph.snapshot().nodes
        (reply,) = client.session.get(f"@/{token.zid}/peer")
        assert reply.ok is not None
        assert b"B 12" in reply.ok.payload.to_bytes()


@pytest.mark.parametrize("domain_id", [-1, 233, "x", 1.5])
def test_init_refuses_a_domain_out_of_range(domain_id: int) -> None:
    with pytest.raises(ValueError, match="a whole number from 0 to 232"):
        zbot.Context().init([], domain_id=domain_id)
