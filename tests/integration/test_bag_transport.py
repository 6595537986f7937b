"""Tests of the recorder and the player of `rosbag2_py`."""

from __future__ import annotations

import re
import threading
from typing import TYPE_CHECKING, Any

import pytest

import zbot
import zbot.compat  # noqa: F401 - makes rosbag2_py importable
from tests.conftest import allowed, wait_until
from zbot.bag import Reader, Writer, read
from zbot.bag.errors import BagError

from std_msgs.msg import String

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from tests.conftest import MakeContext, Spin
    from zbot.log.record import Record


@pytest.fixture
def rosbag2_py() -> Any:
    return pytest.importorskip("rosbag2_py")


def running(work: Callable[..., None], *arguments: Any) -> threading.Thread:
    thread = threading.Thread(target=work, args=arguments, daemon=True)
    thread.start()
    return thread


def test_a_recording_ends_at_cancel(
    rosbag2_py: Any, tmp_path: Path, make_context: MakeContext
) -> None:
    publisher = zbot.Node("speaker", context=make_context()).create_publisher(String, "chatter", 10)
    options = rosbag2_py.RecordOptions()
    options.topics = ["chatter"]
    storage = rosbag2_py.StorageOptions(str(tmp_path / "bag"), "mcap")
    recorder = rosbag2_py.Recorder("warn")
    thread = running(recorder.record, storage, options)
    assert wait_until(lambda: publisher.get_subscription_count() == 1)
    for number in range(10):
        publisher.publish(String(data=str(number)))

    def recorded() -> list[str]:
        return [message.data for _, message, _ in read(tmp_path / "bag")]

    assert wait_until(lambda: recorded() == list("0123456789"))  # an open bag can be read
    recorder.cancel()
    thread.join(allowed(5))
    assert not thread.is_alive()
    assert recorded() == list("0123456789")


def test_lost_messages_are_counted_and_said(
    rosbag2_py: Any,
    tmp_path: Path,
    make_context: MakeContext,
    logged: list[Record],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    is_quick = threading.Event()
    write = Writer.write_serialized

    def write_slowly(*arguments: Any) -> None:
        assert is_quick.wait(allowed(20))
        write(*arguments)

    def lost() -> int:
        texts = (
            re.search(r"(\d+) messages were lost: /chatter", record.message) for record in logged
        )
        return max((int(found[1]) for found in texts if found), default=0)

    monkeypatch.setattr(Writer, "write_serialized", write_slowly)
    publisher = zbot.Node("speaker", context=make_context()).create_publisher(String, "chatter", 10)
    options = rosbag2_py.RecordOptions()
    options.topics = ["chatter"]
    storage = rosbag2_py.StorageOptions(str(tmp_path / "bag"), "mcap", max_cache_size=1)
    recorder = rosbag2_py.Recorder("warn")
    thread = running(recorder.record, storage, options)
    assert wait_until(lambda: publisher.get_subscription_count() == 1)
    for number in range(10):
        publisher.publish(String(data=str(number)))
    # One message is with the writer, and one waits.
    assert wait_until(lambda: lost() >= 8)
    is_quick.set()
    recorder.cancel()
    thread.join(allowed(5))
    with Reader(tmp_path / "bag") as bag:
        assert bag.metadata.message_count + lost() == 10
        assert bag.metadata.custom_data == {"lost_messages": f"/chatter {lost()}"}


def test_a_playback_ends_at_cancel(
    rosbag2_py: Any, tmp_path: Path, make_context: MakeContext, spin: Spin
) -> None:
    with Writer(tmp_path / "bag") as bag:
        bag.write("/a", String(data="one"), 1)
        bag.write("/a", String(data="two"), 10**15)
    heard: list[str] = []
    node = zbot.Node("ear", context=make_context())
    node.create_subscription(String, "/b", lambda message: heard.append(message.data), 10)
    spin(node)
    options = rosbag2_py.PlayOptions()
    options.topic_remapping_options = ["--ros-args", "--remap", "/a:=/b"]
    player = rosbag2_py.Player()
    thread = running(player.play, rosbag2_py.StorageOptions(str(tmp_path / "bag")), options)
    assert wait_until(lambda: heard == ["one"])
    player.cancel()
    thread.join(allowed(5))
    assert not thread.is_alive()


@pytest.mark.parametrize("name", ["Player", "Recorder"])
def test_a_wrong_log_level_is_one_error(rosbag2_py: Any, name: str) -> None:
    with pytest.raises(BagError, match="choose one of debug, info"):
        getattr(rosbag2_py, name)("loud")


def test_bags_are_rewritten(rosbag2_py: Any, tmp_path: Path) -> None:
    with Writer(tmp_path / "bag") as bag:
        bag.write("/a", String(data="one"), 1)
        bag.write("/b", String(data="two"), 2)
    outputs = tmp_path / "out.yaml"
    copy = tmp_path / "copy"
    outputs.write_text(
        f"output_bags: [{{uri: {copy}, storage_id: sqlite3, all: true, exclude: a}}]"
    )
    rosbag2_py.bag_rewrite([rosbag2_py.StorageOptions(str(tmp_path / "bag"))], str(outputs))
    assert [message.data for _, message, _ in read(copy)] == ["two"]
