"""Tests of `zbot bag play` with running nodes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

import zbot as library
from tests.cli.bag.programs import LATCHED, Heard, make_bag, text_bag, words_of
from tests.cli.bag.terminal import Terminal, posix
from tests.cli.command import zbot
from tests.conftest import allowed, wait_until
from zbot.bag import Writer
from zbot.bag.message import Definition
from zbot.bag.metadata import TopicMetadata
from zbot.wire.serialization import serialize_message

from rosgraph_msgs.msg import Clock
from std_msgs.msg import String
from std_srvs.srv import SetBool

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import MakeContext, Spin, Start


def test_play_publishes_with_the_recorded_times(
    start: Start, bag: Path, heard: list[tuple[str, str, float]]
) -> None:
    text_bag(bag, "one", "two", "three", step_s=0.6)
    program = start("zbot", "bag", "play", "lesson")
    assert program.wait() == 0
    assert "[rosbag2_player]: Set rate to 1" in program.lines[0]
    assert wait_until(lambda: len(heard) == 3)
    assert words_of(heard) == [("/a", "one"), ("/a", "two"), ("/a", "three")]
    assert heard[2][2] - heard[0][2] > 0.4  # 1.2 s, less if the first one was late


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["--topics", "/b"], ["/b 1", "/b 3"]),
        (["-e", "^/a"], ["/a 0", "/a 2"]),
        (["-x", "^/a"], ["/b 1", "/b 3"]),
        (["--exclude-topics", "b"], ["/a 0", "/a 2"]),
        (["--start-offset", "0.15"], ["/a 2", "/b 3"]),
        (["--playback-duration", "0.1"], ["/a 0", "/b 1"]),
        (["--playback-until-sec", "100.2"], ["/a 0", "/b 1", "/a 2"]),
        (["--playback-until-nsec", "100100000000"], ["/a 0", "/b 1"]),
        (["--topics", "/a", "--remap", "/a:=/renamed"], ["/renamed 0", "/renamed 2"]),
        (["--rate", "4"], ["/a 0", "/b 1", "/a 2", "/b 3"]),
    ],
)
def test_options_of_play_select_messages(
    start: Start,
    bag: Path,
    heard: list[tuple[str, str, float]],
    words: list[str],
    expected: list[str],
) -> None:
    topics = ("/a", "/b", "/a", "/b")
    lines = [(topic, String(data=str(n)), 100 + n * 0.1) for n, topic in enumerate(topics)]
    make_bag(bag, *lines)
    assert start("zbot", "bag", "play", "lesson", *words).wait() == 0
    assert wait_until(lambda: len(heard) >= len(expected))
    # On a busy machine, a subscriber may take messages of two topics in another order.
    assert sorted(f"{topic} {text}" for topic, text in words_of(heard)) == sorted(expected)


def test_play_loops_until_ctrl_c(
    start: Start, bag: Path, heard: list[tuple[str, str, float]]
) -> None:
    text_bag(bag, "one", "two", step_s=0.05)
    program = start("zbot", "bag", "play", "lesson", "--loop")
    assert wait_until(lambda: len(heard) >= 6, 20)
    assert program.stop() == 0
    assert [text for _, text, _ in heard[:4]] == ["one", "two", "one", "two"]


def test_a_loop_without_messages_ends(start: Start, bag: Path) -> None:
    text_bag(bag, "one")
    program = start("zbot", "bag", "play", "lesson", "--loop", "--start-offset", "5")
    assert program.wait() == 0


def test_several_bags_are_played_as_one(
    start: Start, tmp_path: Path, heard: list[tuple[str, str, float]]
) -> None:
    text_bag(tmp_path / "first", "one", "three", step_s=0.2)
    make_bag(tmp_path / "second", ("/b", String(data="two"), 100.1))
    assert start("zbot", "bag", "play", "-i", "first", "mcap", "-i", "second").wait() == 0
    assert wait_until(lambda: len(heard) == 3)
    assert [text for _, text, _ in heard] == ["one", "two", "three"]


def test_latched_messages_from_before_the_start_are_published_first(
    start: Start, bag: Path, heard: list[tuple[str, str, float]]
) -> None:
    with Writer(bag) as writer:
        writer.create_topic(
            TopicMetadata("/a", "std_msgs/msg/String", offered_qos_profiles=(LATCHED,))
        )
        for number in range(4):
            writer.write("/a", String(data=f"map {number}"), 100 * 10**9 + number)
        writer.write("/b", String(data="late"), 106 * 10**9)
    assert start("zbot", "bag", "play", "lesson", "--start-offset", "5").wait() == 0
    assert wait_until(lambda: len(heard) == 3)
    assert [text for _, text, _ in heard] == ["map 2", "map 3", "late"]


def test_play_publishes_the_clock(
    start: Start, bag: Path, make_context: MakeContext, spin: Spin
) -> None:
    times: list[float] = []
    node = library.Node("watch", context=make_context())
    node.create_subscription(
        Clock,
        "/clock",
        lambda message: times.append(message.clock.sec + message.clock.nanosec / 1e9),
        10,
    )
    spin(node)
    text_bag(bag, "one", "two", step_s=1.0)
    assert start("zbot", "bag", "play", "lesson", "--clock", "--rate", "2").wait() == 0
    assert wait_until(lambda: len(times) > 5 and times[-1] > 100.5)
    assert times == sorted(times)
    assert 100 <= times[0] < 101.2


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["--clock-topics", "/b"], [101, 103]),
        (["--clock-topics-all"], [100, 101, 102, 103]),
    ],
)
def test_the_clock_comes_with_messages(
    start: Start,
    bag: Path,
    make_context: MakeContext,
    spin: Spin,
    words: list[str],
    expected: list[int],
) -> None:
    times: list[int] = []
    node = library.Node("watch", context=make_context())
    node.create_subscription(Clock, "/clock", lambda message: times.append(message.clock.sec), 10)
    spin(node)
    lines = [(topic, String(), 100.0 + n) for n, topic in enumerate(("/a", "/b", "/a", "/b"))]
    make_bag(bag, *lines)
    assert start("zbot", "bag", "play", "lesson", "--rate", "5", *words).wait() == 0
    assert wait_until(lambda: len(times) == len(expected))
    assert times == expected


def test_a_profile_of_a_file_is_used(
    start: Start, bag: Path, make_context: MakeContext, spin: Spin
) -> None:
    text_bag(bag, "one", "two", step_s=1000)
    (bag.parent / "qos.yaml").write_text("/a: {durability: transient_local, depth: 3}\n")
    program = start("zbot", "bag", "play", "lesson", "--qos-profile-overrides-path", "qos.yaml")
    program.wait_for("Set rate to 1")
    assert "Overriding QoS profile for topic /a" in program.output
    node = library.Node("late", context=make_context())
    late: list[str] = []
    node.create_subscription(String, "/a", lambda message: late.append(message.data), LATCHED)
    spin(node)
    assert wait_until(lambda: late == ["one"])
    program.stop()


def test_types_without_a_definition_here_come_from_the_bag(start: Start, bag: Path) -> None:
    with Writer(bag) as writer:
        writer.create_topic(
            TopicMetadata("/cow", "far_zoo_msgs/msg/Cow"), Definition("ros2msg", "int8 legs\n")
        )
        writer.write_serialized("/cow", b"\x00\x01\x00\x00\x04", 1)
    program = start("zbot", "bag", "play", "lesson", "--loop", "--delay", "0.05")
    done = zbot("topic", "echo", "/cow", "--once", "--timeout", "15")
    assert (done.code, done.out) == (0, "legs: 4\n---\n")
    assert program.stop() == 0


def test_a_topic_of_an_unknown_type_is_left_out(
    start: Start, bag: Path, heard: list[tuple[str, str, float]]
) -> None:
    with Writer(bag) as writer:
        writer.create_topic(TopicMetadata("/x", "no_msgs/msg/No"), Definition("", ""))
        writer.write_serialized("/x", b"", 1)
        writer.write("/a", String(data="one"), 2)
    program = start("zbot", "bag", "play", "lesson")
    assert program.wait() == 0
    assert "Ignoring a topic '/x', reason: " in program.output
    assert wait_until(lambda: [text for _, text, _ in heard] == ["one"])


@pytest.mark.parametrize(
    ("words", "code", "sentence"),
    [
        (["none"], 1, "Bag path 'none' does not exist!"),
        ([], 2, "say which bag to play"),
        (["lesson", "--rate", "0"], 2, "not in the valid range (> 0.0)"),
        (["lesson", "--clock", "-1"], 2, "--clock -1 is not in the valid range"),
        (["lesson", "--remap", "a=b"], 1, "--remap 'a=b' is not OLD_TOPIC:=NEW_TOPIC"),
        (["lesson", "-i", "lesson"], 2, "BAG and --input exclude each other"),
        (
            ["lesson", "--clock", "--clock-topics", "/a"],
            2,
            "--clock and --clock-topics exclude each other",
        ),
        (
            ["lesson", "--playback-until-sec", "1", "--playback-until-nsec", "1"],
            2,
            "--playback-until-sec and --playback-until-nsec exclude each other",
        ),
        (["lesson", "-s", "sqlite3"], 1, "its storage is mcap, not sqlite3"),
        (["lesson", "-x", "["], 1, "'[' is not a regular expression: "),
    ],
)
def test_mistakes_of_play_are_one_sentence(
    words: list[str], code: int, sentence: str, bag: Path, tmp_path: Path
) -> None:
    text_bag(bag, "one")
    done = zbot("bag", "play", *words, cwd=tmp_path)
    assert done.code == code
    assert sentence in done.err


@posix
def test_keys_control_a_playback(bag: Path, heard: list[tuple[str, str, float]]) -> None:
    text_bag(bag, "one", "two", "three", step_s=0.05)
    terminal = Terminal(bag.parent, "bag", "play", "lesson", "--start-paused")
    try:
        terminal.wait_for("Press SPACE for Pause/Resume")
        terminal.wait_for("Set rate to 1")
        terminal.press("\x1b[A")
        terminal.wait_for("Set rate to 1.1")
        terminal.press("\x1b[B")
        terminal.wait_for("Set rate to 0.99")
        terminal.press("\x1b[C")
        assert wait_until(lambda: len(heard) == 1)
        assert words_of(heard) == [("/a", "one")]
        terminal.press(" ")
        terminal.wait_for("Resuming play.")
        assert wait_until(lambda: len(heard) == 3)
        assert terminal.process.wait(allowed(30)) == 0
    finally:
        terminal.close()


@posix
def test_a_burst_publishes_at_once_and_pauses(bag: Path, heard: Heard) -> None:
    text_bag(bag, "one", "two", "three", step_s=1000)
    terminal = Terminal(bag.parent, "bag", "burst", "lesson", "-n", "2")
    try:
        assert wait_until(lambda: len(heard) == 2)
        terminal.wait_for("====== Playback Progress ======")
        terminal.wait_for("Duration 1000.00/2000.00 [P]")
        terminal.press("s")
        assert wait_until(lambda: len(heard) == 3)
        assert terminal.process.wait(allowed(30)) == 0
    finally:
        terminal.close()


def test_the_log_level_selects_lines(start: Start, bag: Path) -> None:
    text_bag(bag, "one")
    program = start("zbot", "bag", "play", "lesson", "--log-level", "error")
    assert program.wait() == 0
    assert program.output == ""


def test_a_burst_of_everything_ends(start: Start, bag: Path, heard: Heard) -> None:
    text_bag(bag, "one", "two", "three", step_s=1000)
    program = start("zbot", "bag", "burst", "lesson", "--remap", "/a:=/renamed")
    assert program.wait() == 0
    assert "Progress" not in program.output  # it is no terminal
    assert wait_until(lambda: len(heard) == 3)
    assert words_of(heard)[0] == ("/renamed", "one")


def test_messages_are_played_in_the_order_of_sending(start: Start, bag: Path, heard: Heard) -> None:
    data = [serialize_message(String(data=text)) for text in ("late", "early")]
    with Writer(bag) as writer:
        writer.create_topic(TopicMetadata("/a", "std_msgs/msg/String"))
        writer.write_serialized("/a", data[0], 10_000_000, 9_000_000)
        writer.write_serialized("/a", data[1], 11_000_000, 8_000_000)
    assert start("zbot", "bag", "play", "lesson", "--message-order", "sent").wait() == 0
    assert wait_until(lambda: len(heard) == 2)
    assert words_of(heard) == [("/a", "early"), ("/a", "late")]


def test_wait_for_all_acked_ends_after_the_subscribers(
    start: Start, bag: Path, heard: Heard
) -> None:
    text_bag(bag, *map(str, range(500)), step_s=0.0001)
    program = start("zbot", "bag", "play", "lesson", "--wait-for-all-acked", "10000")
    assert program.wait() == 0
    assert "Timed out" not in program.output
    assert wait_until(lambda: bool(heard) and heard[-1][1] == "499")


@pytest.mark.parametrize(
    ("source", "received"), [("service_introspection", [True]), ("client_introspection", [])]
)
def test_recorded_requests_are_sent_to_the_service(
    start: Start,
    bag: Path,
    make_context: MakeContext,
    spin: Spin,
    source: str,
    received: list[bool],
) -> None:
    request = SetBool.Request(data=True)
    with Writer(bag) as writer:
        for kind in (1, 2):  # received by the server, sent by the server
            event = SetBool.Event(request=[request] if kind == 1 else [])
            event.info.event_type = kind
            writer.write("/lamp/_service_event", event, kind)
    found: list[bool] = []

    def switch(request: SetBool.Request, response: SetBool.Response) -> SetBool.Response:
        found.append(request.data)
        return response

    server = library.Node("server", context=make_context())
    server.create_service(SetBool, "lamp", switch)
    spin(server)
    words = ("--publish-service-requests", "--service-requests-source", source)
    program = start("zbot", "bag", "play", "lesson", *words)
    assert program.wait() == 0
    assert wait_until(lambda: found == received)
    assert "not running" not in program.output
