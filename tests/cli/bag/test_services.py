"""Tests of the services of the recorder and of the player."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest
from rosbag2_interfaces.msg import WriteSplitEvent
from rosbag2_interfaces.srv import (
    Burst,
    GetRate,
    IsPaused,
    Pause,
    PlayNext,
    Resume,
    Seek,
    SetRate,
    Snapshot,
    SplitBagfile,
    Stop,
    TogglePaused,
)

import zbot as library
from tests.cli.bag.programs import Heard, grow, recording, size, text_bag, words_of
from tests.conftest import allowed, wait_until
from zbot import bag as bags

from builtin_interfaces.msg import Time

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import MakeContext, Spin, Start


class Caller:
    """Node that calls services of a recorder or a player."""

    def __init__(self, node: library.Node, prefix: str) -> None:
        self.node, self._prefix = node, prefix

    def call(self, service: Any, **fields: Any) -> Any:
        """Call the service whose name belongs to its class: `is_paused` for `IsPaused`."""
        name = "".join(
            f"_{character.lower()}" if character.isupper() else character
            for character in service.__name__
        )
        client = self.node.create_client(service, f"{self._prefix}/{name[1:]}")
        assert client.wait_for_service(allowed(10))
        return client.call(service.Request(**fields), timeout_sec=allowed(10))


@pytest.fixture
def recorder(make_context: MakeContext, spin: Spin) -> Caller:
    node = library.Node("caller", context=make_context())
    spin(node)
    return Caller(node, "/rosbag2_recorder")


@pytest.mark.usefixtures("robot")
def test_services_pause_and_split_a_recording(start: Start, bag: Path, recorder: Caller) -> None:
    splits: list[WriteSplitEvent] = []
    recorder.node.create_subscription(WriteSplitEvent, "/events/write_split", splits.append, 10)
    program = recording(start, "--topics", "/chatter", "/map", "--repeat-latched")
    program.wait_for("All requested topics are subscribed.")
    grow(bag)
    assert recorder.call(IsPaused).paused is False
    recorder.call(Pause)
    assert recorder.call(IsPaused).paused is True
    recorder.call(Resume)
    assert recorder.call(IsPaused).paused is False
    grow(bag)
    recorder.call(SplitBagfile)
    assert wait_until(lambda: len(splits) == 1)
    assert splits[0].closed_file.endswith("lesson_0.mcap")
    assert splits[0].opened_file.endswith("lesson_1.mcap")
    assert splits[0].node_name == "/rosbag2_recorder"
    assert wait_until(lambda: (bag / "lesson_1.mcap").stat().st_size > 2000)
    assert program.stop() == 0
    assert "Pausing recording." in program.output
    numbers = [int(m.data) for _, m, _ in bags.read(bag, ["/chatter"])]
    assert numbers == sorted(set(numbers))
    second = [topic for topic, _, _ in bags.read(bag / "lesson_1.mcap")]
    assert second[0] == "/map"


@pytest.mark.usefixtures("robot")
def test_snapshots_are_written_when_the_service_is_called(
    start: Start, bag: Path, recorder: Caller
) -> None:
    heard: list[Any] = []
    from std_msgs.msg import String  # noqa: PLC0415 - zbot makes it importable

    program = recording(start, "/chatter", "--snapshot-mode", "--max-cache-duration", "60")
    program.wait_for("All requested topics are subscribed.")
    recorder.node.create_subscription(String, "/chatter", heard.append, 10)
    assert wait_until(lambda: len(heard) > 30)
    before = size(bag)
    assert recorder.call(Snapshot).success is True
    assert wait_until(lambda: size(bag) > before + 500)
    count = len(heard)
    assert wait_until(lambda: len(heard) > count + 10)
    assert recorder.call(Snapshot).success is True
    assert wait_until((bag / "lesson_1.mcap").exists)
    assert program.stop() == 0
    first = [int(m.data) for _, m, _ in bags.read(bag / "lesson_0.mcap")]
    second = [int(m.data) for _, m, _ in bags.read(bag / "lesson_1.mcap")]
    assert len(first) > 20
    assert first + second == list(range(first[0], second[-1] + 1))


@pytest.mark.usefixtures("robot")
def test_a_recording_in_sqlite_survives_sigkill(start: Start, bag: Path) -> None:
    program = recording(start, "/chatter", "-s", "sqlite3")
    program.wait_for("All requested topics are subscribed.")

    def numbers() -> list[int]:
        return [int(m.data) for _, m, _ in bags.read(bag)]

    assert wait_until(lambda: len(numbers()) > 5)
    program.process.kill()
    program.wait()
    found = numbers()
    assert found == list(range(found[0], found[0] + len(found)))


@pytest.fixture
def player(make_context: MakeContext, spin: Spin) -> Caller:
    node = library.Node("caller", context=make_context())
    spin(node)
    return Caller(node, "/rosbag2_player")


def test_services_control_a_playback(start: Start, bag: Path, heard: Heard, player: Caller) -> None:
    text_bag(bag, *map(str, range(10)), step_s=100)
    program = start("zbot", "bag", "play", "lesson", "--start-paused")
    assert player.call(IsPaused).paused is True
    assert player.call(PlayNext).success is True
    assert wait_until(lambda: len(heard) == 1)
    assert player.call(Burst, num_messages=2).actually_burst == 2
    assert wait_until(lambda: len(heard) == 3)
    assert player.call(Seek, time=Time(sec=700)).success is True
    assert player.call(Seek, time=Time(sec=7000)).success is False
    assert player.call(PlayNext).success is True
    assert wait_until(lambda: len(heard) == 4)
    assert [text for _, text in words_of(heard)] == ["0", "1", "2", "6"]
    assert player.call(SetRate, rate=-1.0).success is False
    assert player.call(SetRate, rate=500.0).success is True
    assert player.call(GetRate).rate == 500
    player.call(TogglePaused)
    assert program.wait() == 0
    assert [text for _, text in words_of(heard)] == ["0", "1", "2", "6", "7", "8", "9"]


def test_stop_ends_a_playback(start: Start, bag: Path, player: Caller) -> None:
    text_bag(bag, "one", "two", step_s=1000)
    program = start("zbot", "bag", "play", "lesson")
    assert player.call(IsPaused).paused is False
    assert player.call(PlayNext).success is False
    player.call(Stop)
    assert program.wait() == 0
