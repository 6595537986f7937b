"""Tests of `zbot bag record` with running nodes."""

from __future__ import annotations

import signal
import subprocess
import sys
from typing import TYPE_CHECKING

import pytest

import zbot as library
from tests.cli.bag.programs import Robot, grow, recording, size
from tests.cli.bag.terminal import Terminal, posix
from tests.cli.command import zbot
from tests.conftest import allowed, wait_until
from zbot import bag as bags
from zbot.bag import Reader
from zbot.errors.installation import pip_install
from zbot.node.service_introspection import ServiceIntrospectionState
from zbot.qos import DurabilityPolicy, QoSProfile

from builtin_interfaces.msg import Time
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Int32
from std_srvs.srv import SetBool

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import MakeContext, Spin, Start


@pytest.mark.usefixtures("robot")
def test_a_topic_that_nobody_publishes_is_named_with_a_similar_topic(start: Start) -> None:
    recording(start, "--topics", "/chater").wait_for("did you mean '/chatter'?")


@pytest.mark.usefixtures("robot")
def test_record_writes_live_topics_until_ctrl_c(start: Start, bag: Path) -> None:
    program = recording(start, "--topics", "/chatter", "scan", "/map")
    program.wait_for("All requested topics are subscribed. Stopping discovery...")
    grow(bag)
    assert program.stop() == 0
    assert "Subscribed to topic '/scan'" in program.output
    assert "Recording stopped" in program.output
    assert "lost" not in program.output
    found = list(bags.read(bag))
    numbers = [int(message.data) for topic, message, _ in found if topic == "/chatter"]
    assert numbers == list(range(numbers[0], numbers[0] + len(numbers)))
    assert len(numbers) > 5
    assert [message.data for topic, message, _ in found if topic == "/map"] == ["room"]
    scans = [message for topic, message, _ in found if topic == "/scan"]
    assert list(scans[0].ranges) == [1.0, 2.0]
    with Reader(bag) as read:
        [profile] = read.topics["/map"].offered_qos_profiles
        assert profile.durability is DurabilityPolicy.TRANSIENT_LOCAL
        recorded = next(read.messages(["/chatter"]))
    assert 0 <= recorded.log_ns - recorded.publish_ns < 10_000_000_000


@pytest.mark.usefixtures("robot")
def test_sigterm_ends_a_recording_completely(start: Start, bag: Path) -> None:
    program = recording(start, "-a")
    grow(bag)
    program.stop(signal.SIGTERM)
    assert (bag / "metadata.yaml").exists()


def test_topics_that_appear_later_are_recorded(
    start: Start, bag: Path, make_context: MakeContext
) -> None:
    program = recording(start, "-e", "/late.*", "--exclude-topics", "/late_not")
    node = library.Node("late", context=make_context())
    publisher = node.create_publisher(Int32, "late", 10)
    node.create_publisher(Int32, "late_not", 10)
    program.wait_for("Subscribed to topic '/late'")
    assert wait_until(lambda: publisher.get_subscription_count() == 1)
    publisher.publish(Int32(data=7))
    assert wait_until(lambda: b"late" in (bag / "lesson_0.mcap").read_bytes() or size(bag) > 300)
    assert program.stop() == 0
    assert [(topic, message) for topic, message, _ in bags.read(bag)] == [("/late", Int32(data=7))]


@pytest.mark.usefixtures("robot")
@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["--topic-types", "sensor_msgs/LaserScan"], {"/scan"}),
        (["--all-topics", "-x", "/scan|/rosout|/param"], {"/chatter", "/map"}),
        (["-a", "--exclude-topic-types", "std_msgs/msg/String"], {"/scan", "/rosout"}),
        (["--topics", "/chatter", "--no-discovery"], {"/chatter"}),
    ],
)
def test_options_select_topics(
    start: Start, bag: Path, words: list[str], expected: set[str]
) -> None:
    program = recording(start, *words)
    for topic in expected:
        program.see(f"Subscribed to topic '{topic}'")
    grow(bag)
    assert program.stop() == 0
    with Reader(bag) as read:
        assert set(read.topics) - {"/parameter_events"} == expected


@pytest.mark.usefixtures("robot")
def test_a_recording_is_split(start: Start, bag: Path) -> None:
    program = recording(start, "/chatter", "-b", "4000", "--compression-mode", "file")
    assert wait_until((bag / "lesson_2.mcap").exists, 20)
    assert program.stop() == 0
    numbers = [int(message.data) for _, message, _ in bags.read(bag)]
    assert numbers == list(range(numbers[0], numbers[0] + len(numbers)))
    assert [path.suffix for path in bag.glob("*_0.*")] == [".zstd"]


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        ([], "Need to specify at least one option out of --all, --all-topics,"),
        (["--topics", "/a", "--exclude-topics", "/b"], "--exclude-topics argument requires"),
        (["-e", "("], "'(' is not a regular expression: "),
        (["-a", "--use-sim-time", "--no-discovery"], "are incompatible settings"),
        (["-a", "--snapshot-mode", "--max-cache-size", "0"], "shall not be set to zero"),
        (["-a", "--storage-config-file", "none.yaml"], "No such file"),
        (["--topics", "/a", "--exclude-actions", "/b"], "--exclude-actions argument requires"),
        (["-a", "-b", "10"], "--max-bag-size 10 is too small"),
        (["-a", "--custom-data", "x"], "--custom-data 'x' is not KEY=VALUE"),
        (["-a", "--qos-profile-overrides-path", "none.yaml"], "No such file"),
        (["-a", "-o", "."], "Output folder '.' already exists."),
    ],
)
@pytest.mark.own_dialect("in ROS 2 a command looks for a router first")
def test_mistakes_are_one_sentence(words: list[str], sentence: str, tmp_path: Path) -> None:
    done = zbot("bag", "record", *words, cwd=tmp_path)
    assert done.code == 1
    assert sentence in done.err.splitlines()[0]
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    "words",
    [
        ["-a", "-s", "rosbag_v2"],
        ["/a", "--topics", "/b"],
        ["-a", "--compression-format", "zstd"],
        ["-a", "--compression-mode", "message", "--compression-format", "lz4"],
    ],
)
def test_options_that_do_not_fit_are_refused(words: list[str]) -> None:
    assert zbot("bag", "record", *words).code == 2


@posix
@pytest.mark.usefixtures("robot")
def test_space_pauses_a_recording(bag: Path) -> None:
    terminal = Terminal(bag.parent, "bag", "record", "-o", "lesson", "--topics", "/chatter")
    try:
        terminal.wait_for("Press SPACE for pausing/resuming")
        terminal.wait_for("Subscribed to topic '/chatter'")
        grow(bag)
        terminal.press(" ")
        terminal.wait_for("Pausing recording.")
        terminal.press(" ")
        terminal.wait_for("Resuming recording.")
        grow(bag)
        terminal.process.send_signal(signal.SIGINT)
        terminal.wait_for("Recording stopped")
        assert terminal.process.wait(allowed(30)) == 0
    finally:
        terminal.close()
    assert len(list(bags.read(bag))) > 2


def test_calls_of_a_service_are_recorded(
    start: Start, bag: Path, make_context: MakeContext, spin: Spin
) -> None:
    server = library.Node("server", context=make_context())
    service = server.create_service(SetBool, "lamp", lambda _, response: response)
    service.configure_introspection(
        server.get_clock(), QoSProfile(depth=10), ServiceIntrospectionState.CONTENTS
    )
    spin(server)
    program = recording(start, "--services", "/lamp")
    program.wait_for("All requested topics are subscribed.")
    assert zbot("service", "call", "/lamp", "std_srvs/srv/SetBool", "data: true").code == 0
    assert wait_until(lambda: size(bag) > 1000)
    assert program.stop() == 0
    shown = zbot("bag", "info", str(bag), "-v").out
    assert "Messages:          0\n" in shown
    assert "Service: /lamp | Type: std_srvs/srv/SetBool | Request Count: 1 | Response" in shown
    events = [message for _, message, _ in bags.read(bag)]
    assert events[0].request[0].data is True


def test_simulated_time_is_recorded(
    start: Start, bag: Path, robot: Robot, make_context: MakeContext, spin: Spin
) -> None:
    program = recording(start, "--topics", "/chatter", "--use-sim-time")
    program.wait_for("All requested topics are subscribed.")
    node = library.Node("clock", context=make_context())
    publisher = node.create_publisher(Clock, "/clock", 10)
    node.create_timer(0.02, lambda: publisher.publish(Clock(clock=Time(sec=7))))
    spin(node)
    grow(bag)
    assert program.stop() == 0
    assert robot.count > 0
    assert {t for _, _, t in bags.read(bag)} == {7_000_000_000}


def test_a_missing_package_is_named_with_the_way_to_install_it(tmp_path: Path) -> None:
    source = "import sys; sys.modules['mcap'] = None; from zbot_cli.__main__ import main; main()"
    (tmp_path / "a.mcap").write_text("x")
    for words in (["info", "a.mcap"], ["play", "a.mcap"], ["record", "-a"]):
        done = subprocess.run(
            [sys.executable, "-c", source, "bag", *words],
            cwd=tmp_path,
            capture_output=True,
            text=True,
            timeout=allowed(30),
            check=False,
        )
        assert done.returncode == 1
        assert done.stderr == f"bags need mcap: install it with {pip_install('zbot[bag]')}\n"
        assert len(list(tmp_path.iterdir())) == 1


def test_the_topics_of_an_action_are_recorded(start: Start, bag: Path) -> None:
    start("zbot", "run", "fibonacci_action_server")
    assert wait_until(lambda: "/fibonacci" in zbot("action", "list").out, 20)
    program = recording(start, "--actions", "/fibonacci")
    goal = ("/fibonacci", "action_tutorials_interfaces/action/Fibonacci", "order: 3")
    assert zbot("action", "send_goal", *goal, timeout_s=60).code == 0
    assert wait_until(lambda: len({topic for topic, _, _ in bags.read(bag)}) == 2)
    assert program.stop() == 0
    shown = zbot("bag", "info", str(bag)).out
    assert (
        "  Action: /fibonacci | Type: action_tutorials_interfaces/action/Fibonacci | Topics: 2"
        in shown
    )
    assert {topic for topic, _, _ in bags.read(bag)} == {
        "/fibonacci/_action/feedback",
        "/fibonacci/_action/status",
    }
