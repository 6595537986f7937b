"""Tests of options of `zbot bag record` that change what is recorded."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from tests.cli.bag.programs import Robot, grow, recording
from tests.cli.command import zbot
from tests.conftest import wait_until
from zbot.bag import Reader
from zbot.qos import ReliabilityPolicy

from std_msgs.msg import String

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import Start


def topics_of(bag: Path) -> set[str]:
    with Reader(bag) as read:
        return set(read.topics)


@pytest.mark.parametrize("words", [[], ["--include-hidden-topics"]])
def test_hidden_topics_are_recorded_only_with_their_option(
    start: Start, bag: Path, robot: Robot, words: list[str]
) -> None:
    robot.node.create_publisher(String, "_secret", 10)
    program = recording(start, "--all-topics", "-p", "20", *words)
    if words:
        assert wait_until(lambda: "Subscribed to topic '/_secret'" in program.output)
    else:
        assert wait_until(lambda: "Enable them with --include-hidden-topics" in program.output)
    grow(bag)
    assert program.stop() == 0
    assert ("/_secret" in topics_of(bag)) == bool(words)


@pytest.mark.parametrize("words", [[], ["--include-unpublished-topics"]])
def test_topics_without_a_publisher_are_recorded_only_with_their_option(
    start: Start, bag: Path, robot: Robot, words: list[str]
) -> None:
    robot.node.create_subscription(String, "wish", print, 10)
    program = recording(start, "--all-topics", *words)
    if words:
        assert wait_until(lambda: "Subscribed to topic '/wish'" in program.output)
    grow(bag)
    assert program.stop() == 0
    assert ("/wish" in topics_of(bag)) == bool(words)


def test_topics_that_nobody_reads_are_left_out(start: Start, bag: Path, robot: Robot) -> None:
    robot.node.create_subscription(String, "chatter", lambda _: None, 10)
    program = recording(start, "--all-topics", "--ignore-leaf-topics")
    grow(bag)
    assert program.stop() == 0
    assert topics_of(bag) == {"/chatter"}


@pytest.mark.usefixtures("robot")
def test_a_recorder_with_another_name_waits_for_its_service(start: Start, bag: Path) -> None:
    words = ("--start-paused", "--disable-keyboard-controls", "--node-name", "camera_man")
    program = start("zbot", "bag", "record", "-o", "lesson", "--topics", "/chatter", *words)
    program.wait_for("Wait for recording: Press SPACE to start.")
    program.wait_for("All requested topics are subscribed.")
    assert zbot("service", "call", "/camera_man/resume", "rosbag2_interfaces/srv/Resume").code == 0
    grow(bag)
    assert program.stop() == 0
    lines = program.lines
    assert all("[camera_man]" in line for line in lines)
    assert [line for line in lines if "Resuming recording." in line]


@pytest.mark.usefixtures("robot")
def test_files_end_after_a_duration(start: Start, bag: Path) -> None:
    program = recording(start, "--topics", "/chatter", "-d", "1")
    assert wait_until((bag / "lesson_1.mcap").exists, 20)
    assert program.stop() == 0
    with Reader(bag) as read:
        first = read.metadata.files[0]
    assert 0 < first.duration_ns <= 1_000_000_000
    assert first.message_count > 1


def test_a_profile_of_a_file_is_used(start: Start, bag: Path, robot: Robot) -> None:
    (bag.parent / "qos.yaml").write_text("/chatter: {reliability: best_effort, depth: 3}\n")
    program = recording(start, "--topics", "/chatter", "--qos-profile-overrides-path", "qos.yaml")
    assert wait_until(lambda: "Overriding subscription profile for /chatter" in program.output)
    assert wait_until(lambda: robot.chatter.get_subscription_count() == 1)
    [info] = robot.node.get_subscriptions_info_by_topic("/chatter")
    assert info.qos_profile.reliability is ReliabilityPolicy.BEST_EFFORT
    assert program.stop() == 0
