"""Parts 3 and 4 of the first lesson by commands alone: a package, its nodes, and a look at them."""

from __future__ import annotations

import importlib.util
import re
from typing import TYPE_CHECKING

import pytest

import zbot.compat  # noqa: F401 - makes rclpy importable
from tests.cli.command import Outcome
from tests.cli.command import zbot as run_zbot

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from tests.conftest import Start

NAME = "my_publisher_subscriber"
PUBLISHER = """\
import random

import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32, String


class PublisherNode(Node):
    def __init__(self):
        super().__init__('publisher_node')
        self.publisher = self.create_publisher(String, 'student_id', 10)
        self.number_publisher = self.create_publisher(Int32, 'random_number', 10)
        self.timer = self.create_timer(0.5, self.timer_callback)

    def timer_callback(self):
        msg = String()
        msg.data = 'S1234567'
        self.publisher.publish(msg)
        number = Int32()
        number.data = random.randint(0, 100)
        self.number_publisher.publish(number)
        self.get_logger().info(f'Publishing: "{msg.data}", {number.data}')


def main(args=None):
    rclpy.init(args=args)
    node = PublisherNode()
    rclpy.spin(node)
    node.destroy_node()
    rclpy.shutdown()


if __name__ == '__main__':
    main()
"""
SUBSCRIBER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class SubscriberNode(Node):
    def __init__(self):
        super().__init__('subscriber_node')
        self.subscription = self.create_subscription(String, 'student_id', self.callback, 10)

    def callback(self, msg):
        self.get_logger().info(f'I heard: "{msg.data}"')


def main(args=None):
    rclpy.init(args=args)
    node = SubscriberNode()
    rclpy.spin(node)
    node.destroy_node()
    rclpy.shutdown()
"""
ENTRIES = """'console_scripts': [
            'publisher_node = my_publisher_subscriber.publisher_node:main',
            'subscriber_node = my_publisher_subscriber.subscriber_node:main',"""

needs_rclpy = pytest.mark.skipif(
    importlib.util.find_spec("rclpy") is None, reason="zbot has no names of rclpy yet"
)


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    (tmp_path / "src").mkdir()
    return tmp_path


@pytest.fixture
def command(workspace: Path) -> Callable[..., str]:
    """Return a function that runs `zbot` in the workspace, and returns what it says."""

    def run(*words: str, folder: str = ".", code: int = 0) -> str:
        outcome: Outcome = run_zbot(*words, cwd=workspace / folder)
        assert outcome.code == code, outcome.err
        return outcome.out if code == 0 else outcome.err

    return run


@pytest.fixture
def package(workspace: Path, command: Callable[..., str]) -> Path:
    """Return the folder of the package, created as the lesson says."""
    command(
        "pkg", "create", "--build-type", "ament_python", NAME, "--dependencies", "rclpy",
        "std_msgs", folder="src",
    )  # fmt: skip
    return workspace / "src" / NAME


@pytest.fixture
def nodes(package: Path) -> Path:
    """Return the folder of the package with its nodes written and entered."""
    (package / NAME / "publisher_node.py").write_text(PUBLISHER)
    (package / NAME / "subscriber_node.py").write_text(SUBSCRIBER)
    setup = (package / "setup.py").read_text()
    (package / "setup.py").write_text(setup.replace("'console_scripts': [", ENTRIES))
    return package


def test_the_package_has_the_structure_of_the_lesson(package: Path) -> None:
    assert {entry.name for entry in package.iterdir()} == {
        "package.xml", "setup.py", "setup.cfg", "resource", "test", NAME,
    }  # fmt: skip
    assert [entry.name for entry in (package / NAME).iterdir()] == ["__init__.py"]


@pytest.mark.usefixtures("package")
def test_the_package_is_built_and_recognized(command: Callable[..., str]) -> None:
    for options in ([], ["--symlink-install"]):
        built = command("build", *options, "--packages-select", NAME)
        assert f"Starting >>> {NAME}\nFinished <<< {NAME} [" in built
        assert "Summary: 1 package finished [" in built
    assert NAME in command("pkg", "list").splitlines()


def test_a_node_without_an_entry_point_is_told_of(
    package: Path, command: Callable[..., str]
) -> None:
    (package / NAME / "publisher_node.py").write_text(PUBLISHER)
    said = command("run", NAME, "publisher_node", code=1)
    assert said == (
        "No executable found\n\nhint: add 'publisher_node = my_publisher_subscriber."
        "publisher_node:main' to the console_scripts in my_publisher_subscriber's setup.py\n"
    )


def test_a_mistyped_entry_point_fails_to_build(nodes: Path, command: Callable[..., str]) -> None:
    setup = (nodes / "setup.py").read_text()
    (nodes / "setup.py").write_text(setup.replace("publisher_node:main", "publisher_nod:main"))
    said = command("build", "--packages-select", NAME, code=1)
    assert re.search(
        r"setup.py:\d+: 'publisher_node' names the module .*; did you mean 'my_pu", said
    )


def test_a_missing_dependency_is_told_of(nodes: Path) -> None:
    manifest = (nodes / "package.xml").read_text()
    (nodes / "package.xml").write_text(manifest.replace("<depend>std_msgs</depend>", ""))
    outcome = run_zbot("build", cwd=nodes)
    assert outcome.code == 0
    assert "warning: imports std_msgs: add <depend>std_msgs</depend> to package.xml" in outcome.err
    assert "1 package had stderr output" in outcome.out


@needs_rclpy
@pytest.mark.usefixtures("nodes")
def test_the_nodes_are_built_run_and_looked_at(start: Start, command: Callable[..., str]) -> None:
    assert "Finished <<<" in command("build", "--packages-select", NAME)
    assert command("pkg", "executables", NAME) == (
        f"{NAME} publisher_node\n{NAME} subscriber_node\n"
    )
    publisher = start("zbot", "run", NAME, "publisher_node")
    publisher.wait_for('[publisher_node]: Publishing: "S1234567", ')
    subscriber = start("zbot", "run", NAME, "subscriber_node")
    subscriber.wait_for('[subscriber_node]: I heard: "S1234567"')

    assert command("node", "list") == "/publisher_node\n/subscriber_node\n"
    info = command("node", "info", "/publisher_node")
    assert "    /student_id: std_msgs/msg/String\n" in info
    assert {"/random_number", "/student_id"} <= set(command("topic", "list").splitlines())
    assert command("topic", "echo", "--once", "/student_id") == "data: S1234567\n---\n"
    assert re.fullmatch(r"data: \d+\n---\n", command("topic", "echo", "--once", "/random_number"))
    assert command("topic", "info", "/student_id") == (
        "Type: std_msgs/msg/String\nPublisher count: 1\nSubscription count: 1\n"
    )
    meter = start("zbot", "topic", "hz", "/student_id")
    meter.wait_for_rate(2, within_hz=0.4)
    assert meter.stop() == 130
    assert "string data" in command("interface", "show", "std_msgs/msg/String").splitlines()

    subscriber.stop()
    publisher.stop()
    assert "Traceback" not in publisher.output + subscriber.output


@needs_rclpy
def test_a_change_shows_without_a_build(
    nodes: Path, start: Start, command: Callable[..., str]
) -> None:
    file = nodes / NAME / "publisher_node.py"
    file.write_text(PUBLISHER.replace("S1234567", "S7654321"))
    start("zbot", "run", NAME, "publisher_node").wait_for('"S7654321"')
    assert command("topic", "echo", "--once", "/student_id") == "data: S7654321\n---\n"
