"""Tests of the fixtures of `zbot.testing`, as a user's tests use them."""

from __future__ import annotations

import subprocess
import sys
from typing import TYPE_CHECKING

import pytest

import zbot

from example_interfaces.srv import AddTwoInts
from std_msgs.msg import Float32, String
from std_srvs.srv import Trigger

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from zbot.testing import Call, NodeFactory, Received, SpinUntil


class Echo(zbot.Node):
    """Node that publishes what it receives, and adds two numbers."""

    def __init__(self, suffix: str = "") -> None:
        super().__init__("echo")
        self._suffix = suffix
        self._publisher = self.create_publisher(String, "echoed", 10)
        self.create_subscription(String, "said", self._repeat, 10)
        self.create_service(AddTwoInts, "add", self._add)

    def _repeat(self, message: String) -> None:
        if not message.data:
            raise ValueError("nothing was said")
        self._publisher.publish(String(data=message.data + self._suffix))

    def _add(
        self, request: AddTwoInts.Request, response: AddTwoInts.Response
    ) -> AddTwoInts.Response:
        response.sum = request.a + request.b
        return response


def text_of(error: pytest.ExceptionInfo[AssertionError]) -> list[str]:
    return str(error.value).splitlines()


def test_messages_are_received_in_their_order(node: NodeFactory, received: Received) -> None:
    node(Echo, suffix="!")
    publisher = node("tester").create_publisher(String, "said", 10)
    for word in ("one", "two", "three"):
        publisher.publish(String(data=word))
    assert [message.data for message in received("echoed", String, 2)] == ["one!", "two!"]


def test_a_message_that_a_publisher_keeps_is_received(
    node: NodeFactory, received: Received
) -> None:
    qos = zbot.QoSProfile(depth=1, durability=zbot.DurabilityPolicy.TRANSIENT_LOCAL)
    node().create_publisher(String, "map", qos).publish(String(data="floor 2"))
    assert received("map", String) == received("map", String) == [String(data="floor 2")]


def test_a_service_is_called(node: NodeFactory, call: Call) -> None:
    node(Echo)
    assert call("add", AddTwoInts, AddTwoInts.Request(a=2, b=3)).sum == 5


def test_an_exception_of_a_callback_is_that_of_the_test(
    node: NodeFactory, spin_until: SpinUntil
) -> None:
    node(Echo())
    node().create_publisher(String, "said", 10).publish(String())
    with pytest.raises(ValueError, match="nothing was said"):
        spin_until(lambda: False)


def test_a_condition_that_stays_false_is_reported(node: NodeFactory, spin_until: SpinUntil) -> None:
    node(Echo)
    heard = [String(data="hello")]
    with pytest.raises(AssertionError) as error:
        spin_until(lambda: len(heard) > 1, timeout=0.01)
    assert text_of(error) == [
        "the condition was not true within 0.01 s",
        "heard = [std_msgs.msg.String(data='hello')]",
        "nodes:",
        "  /echo",
        "topics:",
        "  /echoed [std_msgs/msg/String]: 1 publisher, 0 subscriptions",
        "  /said [std_msgs/msg/String]: 0 publishers, 1 subscription",
        "services:",
        "  /add [example_interfaces/srv/AddTwoInts]",
    ]


@pytest.mark.parametrize(
    ("topic", "kind", "reason"),
    [
        ("echoes", String, "nobody publishes it; did you mean '/echoed'?"),
        ("echoed", Float32, "its publishers have the type std_msgs/msg/String, and the test has"),
    ],
)
def test_a_message_that_does_not_come_is_reported(
    node: NodeFactory, received: Received, topic: str, kind: type, reason: str
) -> None:
    node(Echo)
    with pytest.raises(AssertionError) as error:
        received(topic, kind, timeout=0.01)
    first, second, *_ = text_of(error)
    assert first == f"0 of 1 messages came on /{topic} within 0.01 s"
    assert second.startswith(reason)


def test_messages_that_came_are_reported(node: NodeFactory, received: Received) -> None:
    node(Echo)
    node().create_publisher(String, "said", 10).publish(String(data="one"))
    with pytest.raises(AssertionError) as error:
        received("echoed", String, 2, timeout=0.5)
    assert text_of(error)[:2] == [
        "1 of 2 messages came on /echoed within 0.5 s",
        "std_msgs.msg.String(data='one')",
    ]


@pytest.mark.parametrize(
    ("service", "kind", "line"),
    [
        ("ad", AddTwoInts, "did you mean '/add'?"),
        ("add", Trigger, "its server has the type example_interfaces/srv/AddTwoInts, and the test"),
    ],
)
def test_a_service_that_cannot_be_called_is_reported(
    node: NodeFactory, call: Call, service: str, kind: type, line: str
) -> None:
    node(Echo)
    with pytest.raises(AssertionError) as error:
        call(service, kind, timeout=0.01)
    assert line in str(error.value)


def test_a_server_that_does_not_answer_is_reported(call: Call) -> None:
    server = zbot.Node("server")  # it does not spin
    server.create_service(Trigger, "slow", lambda _, response: response)
    with pytest.raises(AssertionError, match=r"/slow did not answer within 0\.2 s"):
        call("slow", Trigger, timeout=0.2)


class TestWithThreads:
    """Tests whose nodes run in several threads."""

    @pytest.fixture
    def executor(self, executor: zbot.Executor) -> Iterator[zbot.Executor]:
        assert executor.context.ok()
        with zbot.MultiThreadedExecutor(num_threads=2) as threads:
            yield threads

    def test_a_callback_waits_for_a_service(self, node: NodeFactory, spin_until: SpinUntil) -> None:
        node(Echo)
        sums: list[int] = []
        caller = node("caller")
        group = zbot.ReentrantCallbackGroup()
        client = caller.create_client(AddTwoInts, "add", callback_group=group)

        def ask() -> None:
            timer.cancel()
            sums.append(client.call(AddTwoInts.Request(a=2, b=3), timeout_sec=5).sum)

        timer = caller.create_timer(0.01, ask, callback_group=zbot.MutuallyExclusiveCallbackGroup())
        spin_until(lambda: sums)
        assert sums == [5]


USERS_TEST = """
from std_msgs.msg import String


def test_it_is_silent(start, received):
    program = start('python3', '-c', 'print("my number is", 41 + 1); input()')
    received('chatter', String, timeout=0.3)


def test_it_talks(start, received, domain_id):
    start('zbot', 'run', 'talker')
    print('domain', domain_id, [one.data for one in received('chatter', String)])
"""


def test_the_output_of_programs_is_in_the_report_of_a_failed_test(tmp_path: Path) -> None:
    path = tmp_path / "test_users.py"
    path.write_text(USERS_TEST, encoding="utf-8")
    command = [sys.executable, "-m", "pytest", "-p", "zbot.compat.pytest_plugin", "-rP"]
    command += ["-p", "no:cacheprovider", "-W", "error", str(path)]
    run = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, check=False)
    assert "1 failed, 1 passed" in run.stdout, run.stdout
    assert "my number is 42" in run.stdout
    assert "ended with exit code 1" in run.stdout
    assert "['Hello World: 0']" in run.stdout or "['Hello World: 1']" in run.stdout
