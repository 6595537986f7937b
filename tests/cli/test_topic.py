"""Tests of `zbot topic` and `zbot node` with running nodes."""

from __future__ import annotations

import json
import re
import signal
import sys
from typing import TYPE_CHECKING, Any

import pytest

import zbot as library
from tests.cli.command import zbot
from tests.conftest import wait_until
from zbot.graph.snapshot import foreign_topics
from zbot.transport.config import MEETING_PORT

from sensor_msgs.msg import LaserScan  # isort: skip
from std_msgs.msg import Header, Int32, String  # isort: skip

if TYPE_CHECKING:
    from pathlib import Path

    from tests.cli.conftest import Command
    from tests.conftest import MakeContext, Spin, Start


@pytest.fixture
def robot(make_context: MakeContext, spin: Spin) -> library.Node:
    """Return a node that publishes on /chatter and /robot1/scan at 10 Hz."""
    node = library.Node("robot", context=make_context())
    chatter = node.create_publisher(String, "chatter", 10)
    scan = node.create_publisher(LaserScan, "/robot1/scan", 10)
    node.create_publisher(String, "_hidden", 10)

    def speak() -> None:
        chatter.publish(String(data="hello"))
        stamp = node.get_clock().now().to_msg()
        scan.publish(LaserScan(header=Header(stamp=stamp, frame_id="laser")))

    node.create_timer(0.1, speak)
    spin(node)
    return node


@pytest.mark.usefixtures("robot")
def test_list_shows_the_facts_of_its_options() -> None:
    assert zbot("topic", "list").out == "/chatter\n/parameter_events\n/robot1/scan\n/rosout\n"
    assert zbot("topic", "list", "--count-topics").out == "4\n"
    for option in ("--include-hidden-topics", "--all", "-a"):
        assert "/_hidden\n" in zbot("topic", "list", option).out
        assert "/_hidden\n" in zbot("topic", "find", "std_msgs/msg/String", option).out
    assert zbot("topic", "list", "-v").out == (
        "Published topics:\n"
        " * /chatter [std_msgs/msg/String] 1 publisher\n"
        " * /parameter_events [rcl_interfaces/msg/ParameterEvent] 1 publisher\n"
        " * /robot1/scan [sensor_msgs/msg/LaserScan] 1 publisher\n"
        " * /rosout [rcl_interfaces/msg/Log] 1 publisher\n"
        "\nSubscribed topics:\n\n"
    )
    found = {topic["name"]: topic for topic in json.loads(zbot("topic", "list", "--json").out)}
    assert found["/chatter"]["types"] == ["std_msgs/msg/String"]
    assert found["/chatter"]["publisher_count"] == 1


@pytest.mark.usefixtures("domain")
def test_lists_are_empty_in_an_empty_domain() -> None:
    for words in (["topic", "list"], ["node", "list"]):
        done = zbot(*words)
        assert (done.code, done.out, done.err) == (0, "", "")


@pytest.mark.usefixtures("domain")
@pytest.mark.parametrize(
    "words",
    [["topic", "list"], ["node", "list"], ["service", "list"], ["action", "list"],
     ["param", "list"], ["lifecycle", "nodes"]],
)  # fmt: skip
def test_an_empty_list_says_in_a_terminal_that_no_node_is_running(
    zbot_command: Command, monkeypatch: pytest.MonkeyPatch, words: list[str]
) -> None:
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    done = zbot_command(*words)
    assert (done.code, done.out) == (0, "")
    assert re.fullmatch(
        r"no node is running in domain \d+; start one .*zbot run sensor\n", done.err
    )


@pytest.mark.usefixtures("robot")
@pytest.mark.parametrize(
    "words",
    [["echo"], ["echo", "std_msgs/msg/String"], ["hz"], ["bw"], ["delay"], ["hz", "--json"]],
)
def test_a_silent_topic_is_told_of_once_with_a_similar_name(start: Start, words: list[str]) -> None:
    verb, *more = words
    command = start("zbot", "topic", verb, "/chater", *more)
    command.wait_for("did you mean '/chatter'?")
    command.stop()
    assert command.output.count("did you mean") == 1
    assert "misspelt" not in command.output


@pytest.mark.parametrize("verb", ["hz", "bw", "delay"])
def test_a_publisher_that_sends_nothing_is_named(
    start: Start, make_context: MakeContext, verb: str
) -> None:
    node = library.Node("quiet", context=make_context())
    node.create_publisher(Header, "silence", 10)
    command = start("zbot", "topic", verb, "/silence")
    command.wait_for("no message on /silence yet; its publisher is /quiet")


def test_pub_once_names_a_similar_topic_with_a_publisher(
    start: Start, make_context: MakeContext
) -> None:
    node = library.Node("talker", context=make_context())
    node.create_publisher(String, "chatter", 10)
    command = start("zbot", "topic", "pub", "--once", "/chater", "std_msgs/msg/String")
    command.wait_for("nobody subscribes to /chater; did you mean '/chatter'?")


def test_pub_once_names_a_similar_topic_with_a_subscription(
    start: Start, make_context: MakeContext
) -> None:
    node = library.Node("listener", context=make_context())
    node.create_subscription(String, "chatter", print, 10)
    command = start("zbot", "topic", "pub", "--once", "/chater", "std_msgs/msg/String")
    command.wait_for("nobody subscribes to /chater; did you mean '/chatter'?")


def test_pub_once_of_a_wrong_type_waits_and_names_the_right_one(
    start: Start, make_context: MakeContext
) -> None:
    node = library.Node("listener", context=make_context())
    node.create_subscription(String, "chatter", print, 10)
    command = start("zbot", "topic", "pub", "--once", "/chatter", "std_msgs/msg/Int64")
    command.wait_for("/chatter has two types")
    command.stop()
    assert command.output.count("Waiting for at least 1 matching subscription(s)...") < 10
    assert "publishing #1" not in command.output


@pytest.mark.usefixtures("robot")
@pytest.mark.parametrize(
    ("words", "near"),
    [
        (["topic", "find", "std_msgs/msg/Strin"], "std_msgs/msg/String"),
        (["service", "find", "std_srvs/srv/Emty"], "std_srvs/srv/Empty"),
        (["action", "find", "example_interfaces/action/Fibonaci"], "action/Fibonacci"),
    ],
)
def test_find_refuses_an_unknown_type(words: list[str], near: str) -> None:
    done = zbot(*words)
    assert (done.code, done.out) == (1, "")
    assert f"Unknown type '{words[2]}'" in done.err
    assert near in done.err


@pytest.mark.usefixtures("robot")
def test_find_lists_the_topics_of_a_type() -> None:
    assert zbot("topic", "find", "std_msgs/String").out == "/chatter\n"
    assert zbot("topic", "find", "std_msgs/msg/Bool").code == 0


@pytest.mark.parametrize("verb", ["hz", "bw", "delay"])
def test_a_window_of_no_message_is_refused(verb: str) -> None:
    done = zbot("topic", verb, "-w", "0", "/chatter")
    assert done.code == 2
    assert "0 is not in the range x>=1" in done.err


@pytest.mark.usefixtures("robot")
def test_info_shows_every_endpoint() -> None:
    text = zbot("topic", "info", "chatter", "--verbose").out
    assert re.fullmatch(
        r"Type: std_msgs/msg/String\n\nPublisher count: 1\n\nNode name: robot\nNode namespace: /\n"
        r"Topic type: std_msgs/msg/String\nTopic type hash: RIHS01_df668c[0-9a-f]{58}\n"
        r"Endpoint type: PUBLISHER\nGID: ([0-9a-f]{2}\.){15}[0-9a-f]{2}\nQoS profile:\n"
        r"  Reliability: RELIABLE\n  History \(Depth\): KEEP_LAST \(10\)\n  Durability: VOLATILE\n"
        r"  Lifespan: Infinite\n  Deadline: Infinite\n  Liveliness: AUTOMATIC\n"
        r"  Liveliness lease duration: Infinite\n\nSubscription count: 0\n\n",
        text,
    )


@pytest.mark.usefixtures("robot")
def test_nodes_are_listed_and_described() -> None:
    assert zbot("node", "list").out == "/robot\n"
    assert zbot("node", "list", "-c").out == "1\n"
    assert json.loads(zbot("node", "list", "--json").out) == [
        {"node": "/robot", "name": "robot", "namespace": "/"}
    ]
    assert zbot("node", "info", "robot").out.startswith("/robot\n  Subscribers:\n\n  Publishers:\n")
    found = json.loads(zbot("node", "info", "/robot", "--json").out)
    assert found["publishers"]["/chatter"] == ["std_msgs/msg/String"]


@pytest.mark.usefixtures("robot")
def test_an_unknown_name_suggests_the_nearest() -> None:
    assert "hint: did you mean '/chatter'?" in zbot("topic", "info", "/chattre").err
    assert "hint: did you mean '/robot'?" in zbot("node", "info", "/robott").err


@pytest.mark.parametrize(
    ("words", "wanted"),
    [
        ([], "data: hello\n---\n"),
        (["--json"], '{"data": "hello"}\n'),
        (["--csv"], "hello\n"),
        (["--field", "data"], "hello\n---\n"),
        (["--raw"], "b'\\x81\\xa4data\\xa5hello'\n---\n"),
        (["--filter", "m.data == 'hello'"], "data: hello\n---\n"),
        (["--no-str"], "data: '<string length: <5>>'\n---\n"),
    ],
)
@pytest.mark.usefixtures("robot")
@pytest.mark.own_dialect("one form is the bytes of zbot's own form")
def test_echo_in_every_form(words: list[str], wanted: str) -> None:
    done = zbot("topic", "echo", "--once", "/chatter", *words)
    assert (done.code, done.out) == (0, wanted)


@pytest.mark.usefixtures("robot")
def test_echo_of_several_topics_prints_each_topics_name() -> None:
    done = zbot("topic", "echo", "/chatter", "/robot1/scan", "--timeout", "4")
    assert done.code == 0
    assert "# /chatter\ndata: hello\n---\n" in done.out
    assert "# /robot1/scan\nheader:\n" in done.out


@pytest.mark.usefixtures("robot")
def test_echo_accepts_wildcards() -> None:
    done = zbot("topic", "echo", "/robot*/scan", "--once")
    assert done.out.startswith("# /robot1/scan\nheader:\n")


@pytest.mark.usefixtures("robot")
@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["echo", "/*", "--field", "data"], "hello"),
        (["echo", "/*", "--filter", "m.data == 'hello'"], "data: hello"),
        (["hz", "--all", "--filter", "m.data == 'hello'"], "/chatter "),
    ],
)
def test_a_topic_that_does_not_fit_is_left_out_if_it_is_not_named(
    start: Start, words: list[str], text: str
) -> None:
    command = start("zbot", "topic", *words)
    command.wait_for("cannot show /robot1/scan: ")
    command.wait_for(text)
    assert command.stop() == 130
    assert command.output.count("/robot1/scan: ") == 1


@pytest.mark.usefixtures("domain")
def test_echo_without_a_message_in_time_fails() -> None:
    done = zbot("topic", "echo", "/nothing", "std_msgs/msg/String", "--timeout", "0.3")
    assert (done.code, done.out) == (1, "")
    assert "no message on /nothing within 0.3 s" in done.err


def test_echo_waits_for_publishers_that_come_and_go(start: Start) -> None:
    echo = start("zbot", "topic", "echo", "/chatter")
    echo.wait_for("waiting for /chatter to appear")
    for _ in range(2):
        talker = start("zbot", "run", "talker")
        echo.wait_for("data: 'Hello World: 0'")
        talker.stop(signal.SIGKILL)
    assert echo.stop() == 130
    assert "Traceback" not in echo.output


@pytest.mark.usefixtures("robot")
@pytest.mark.own_dialect("it expects the sizes of zbot's own form")
def test_rates_bandwidths_and_delays_are_printed(start: Start) -> None:
    rate = start("zbot", "topic", "hz", "/chatter")
    bandwidth = start("zbot", "topic", "bw", "/chatter")
    delay = start("zbot", "topic", "delay", "/robot1/scan")
    rate.wait_for_rate(10, within_hz=1)
    assert re.search(r"\tmin: .*s max: .*s std dev: 0\.\d{5}s window: \d+", rate.wait_for("window"))
    bandwidth.wait_for("Subscribed to [/chatter]")
    assert re.fullmatch(r"\d+ B/s from \d+ messages", bandwidth.wait_for("B/s from"))
    assert bandwidth.wait_for("size") == "\tMessage size mean: 12 B min: 12 B max: 12 B"
    delays = [float(delay.wait_for("average delay: ").rpartition(" ")[2]) for _ in range(3)]
    assert min(delays) >= 0
    assert min(delays) < 0.5  # a busy machine may be late once
    assert [meter.stop() for meter in (rate, bandwidth, delay)] == [130, 130, 130]


@pytest.mark.usefixtures("robot")
def test_several_rates_make_a_table(start: Start) -> None:
    rates = start("zbot", "topic", "hz", "/chatter", "/robot1/scan")
    assert rates.wait_for("topic").split() == [
        "topic",
        "rate",
        "min_delta",
        "max_delta",
        "std_dev",
        "window",
    ]
    assert set(rates.wait_for("===")) == {"="}
    rates.wait_for("/chatter ")
    rates.wait_for("/robot1/scan ")


def test_a_delay_needs_a_header(start: Start, robot: library.Node) -> None:
    del robot
    delay = start("zbot", "topic", "delay", "/chatter")
    delay.wait_for("msg does not have header")
    assert delay.wait() == 1


# -- publishing ------------------------------------------------------------------------------------


@pytest.fixture
def inbox(make_context: MakeContext, spin: Spin) -> list[Any]:
    """Return the list of messages that a subscription of /numbers (Int32) receives."""
    heard: list[Any] = []
    node = library.Node("listener", context=make_context())
    node.create_subscription(Int32, "numbers", heard.append, 2000)
    spin(node)
    return heard


def test_pub_on_a_topic_of_two_types_names_them(
    zbot_command: Command, make_context: MakeContext
) -> None:
    node = library.Node("two", context=make_context())
    for type_ in (String, Int32):
        node.create_publisher(type_, "both", 10)
    refused = zbot_command("topic", "pub", "/both", "data: 1")
    assert (refused.code, refused.out) == (1, "")
    assert "Cannot publish on topic '/both'" in refused.err
    assert "[std_msgs/msg/Int32, std_msgs/msg/String]" in refused.err
    assert "e.g. zbot topic pub /both std_msgs/msg/Int32\n" in refused.err


def test_pub_takes_the_type_of_a_known_topic(inbox: list[Any]) -> None:
    done = zbot("topic", "pub", "--once", "/numbers", "{data: 7}")
    assert (done.code, done.err) == (0, "")
    assert "publishing #1: std_msgs.msg.Int32(data=7)" in done.out
    assert wait_until(lambda: [message.data for message in inbox] == [7])


def test_pub_keeps_the_rate_of_1_khz(inbox: list[Any]) -> None:
    done = zbot("topic", "pub", "-t", "1001", "-r", "1000", "-p", "0", "/numbers", "{data: 7}")
    assert done.code == 0
    assert done.out.splitlines()[-1] == "publisher: beginning loop"
    assert wait_until(lambda: len(inbox) == 1001)


def test_pub_reads_standard_input_and_files(inbox: list[Any], tmp_path: Path) -> None:
    assert zbot("topic", "pub", "--once", "--stdin", "/numbers", stdin="data: 1").code == 0
    saved = tmp_path / "saved.yaml"
    saved.write_text("data: 2\n---\ndata: 3\n---\n", encoding="utf-8")
    done = zbot("topic", "pub", "-r", "100", "-w", "1", "/numbers", "--yaml-file", str(saved))
    assert done.code == 0
    assert wait_until(lambda: [message.data for message in inbox] == [1, 2, 3])


@pytest.mark.usefixtures("domain")
def test_pub_waits_at_most_for_the_given_time() -> None:
    done = zbot("topic", "pub", "--once", "--max-wait-time-secs", "0.2", "/x", "std_msgs/Empty")
    assert done.code == 1
    assert "Expected 1 subscribers but only got 0 subscribers" in done.err


@pytest.mark.usefixtures("domain")
def test_pub_of_an_unknown_topic_asks_for_a_type() -> None:
    done = zbot("topic", "pub", "/x", "{data: 1}")
    assert done.code == 1
    assert "hint: name the type: zbot topic pub /x std_msgs/msg/String" in done.err


# -- others ----------------------------------------------------------------------------------------


PLAIN = """
import sys, time, zenoh

port, domain, then = sys.argv[1:]
config = zenoh.Config()
config.insert_json5("mode", '"client"')
config.insert_json5("connect/endpoints", f'["tcp/127.0.0.1:{port}"]')
config.insert_json5("adminspace/enabled", str(then == "talk").lower())
with zenoh.open(config) as session:
    publisher = session.declare_publisher(f"{domain}/plain/topic")
    print("ready", flush=True)
    while then == "talk":
        publisher.put(b"12345")
        time.sleep(0.05)
    while True:
        names = [f"{domain}/fleeting/topic_{number}" for number in range(20)]
        for one in [session.declare_subscriber(name, print) for name in names]:
            one.undeclare()
"""


@pytest.mark.usefixtures("robot")
@pytest.mark.own_dialect("it sends messages in zbot's own form")
def test_a_plain_zenoh_program_is_listed_and_measured(start: Start, domain: int) -> None:
    plain = start(str(MEETING_PORT + domain), str(domain), "talk", source=PLAIN)
    plain.wait_for("ready")
    assert "/plain/topic [unknown]\n" in zbot("topic", "list", "-t").out
    meter = start("zbot", "topic", "bw", "/plain/topic")
    assert meter.wait_for("size") == "\tMessage size mean: 5 B min: 5 B max: 5 B"


def test_lists_do_not_stop_the_domain_while_others_declare(
    robot: library.Node, start: Start, domain: int
) -> None:
    # A query to Zenoh's routers for their known peers can block them for ever.
    for then in ("talk", "declare", "declare"):
        start(str(MEETING_PORT + domain), str(domain), then, source=PLAIN).wait_for("ready")
    client = library.Context(mode="client")
    client.init([], domain_id=domain)
    with client:
        graph = client.graph.snapshot()
        for _ in range(100):
            assert "/plain/topic" in foreign_topics(client.session, graph, domain)
    assert zbot("node", "list").out == f"{robot.get_fully_qualified_name()}\n"


def test_a_node_is_killed_by_name(start: Start) -> None:
    talker = start("zbot", "run", "talker")
    talker.wait_for("Publishing")
    done = zbot("node", "kill", "/talker")
    assert (done.code, done.err) == (0, "")
    assert talker.wait() == -signal.SIGTERM
    assert zbot("node", "list").out == ""


def test_two_nodes_of_one_name_are_reported(start: Start) -> None:
    for _ in range(2):
        start("zbot", "run", "talker").wait_for("Publishing")
    done = zbot("node", "list")
    assert done.out == "/talker\n/talker\n"
    assert (
        "WARNING: Be aware that there are nodes in the graph that share an exact name" in done.err
    )
