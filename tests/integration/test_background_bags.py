"""Tests of recordings in threads of their own that start late, fail or do not end."""

from __future__ import annotations

import threading
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from zbot.bag import background
from zbot.bag.background import BackgroundRecording
from zbot.bag.errors import BagError
from zbot.bag.options import RecordOptions, StorageOptions
from zbot.bag.reader import Reader
from zbot.bag.recorder import Recorder
from zbot.interfaces.parser import parse
from zbot.remote import types
from zbot.wire.tokens import EntityKind

from std_msgs.msg import String

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import MakeContext

EVERYTHING = RecordOptions(all_topics=True)


def recording_threads() -> list[str]:
    return [thread.name for thread in threading.enumerate() if thread.name == "zbot bag recording"]


@pytest.mark.parametrize("late", ["Node", "Recorder"])
def test_a_recording_that_starts_too_late_does_not_go_on(
    domain: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, late: str
) -> None:
    may_start, make = threading.Event(), getattr(background, late)

    def make_late(*arguments: Any, **options: Any) -> Any:
        assert may_start.wait(60)
        return make(*arguments, **options)

    monkeypatch.setattr(background, late, make_late)
    monkeypatch.setattr(background, "_START_S", 0.1)
    with pytest.raises(BagError, match=r"has not started within 0\.1 s"):
        BackgroundRecording(StorageOptions(str(tmp_path / "bag")), EVERYTHING, domain)
    assert recording_threads()
    may_start.set()
    assert wait_until(lambda: not recording_threads(), 10)
    if (tmp_path / "bag").exists():
        with Reader(tmp_path / "bag") as bag:
            assert not bag.damage


class InterruptedEvent(threading.Event):
    """Event whose wait ends by Ctrl-C."""

    def wait(self, timeout: float | None = None) -> bool:
        super().wait(timeout)
        raise KeyboardInterrupt


def test_ctrl_c_ends_a_recording_that_starts(
    domain: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    classes = SimpleNamespace(Event=InterruptedEvent, Thread=threading.Thread)
    monkeypatch.setattr(background, "threading", classes)
    with pytest.raises(KeyboardInterrupt):
        BackgroundRecording(StorageOptions(str(tmp_path / "bag")), EVERYTHING, domain)
    assert not recording_threads()
    with Reader(tmp_path / "bag") as bag:
        assert not bag.damage


def test_an_unexpected_error_is_told(
    domain: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    def defect(*_arguments: Any, **_options: Any) -> None:
        raise KeyError("defect")

    monkeypatch.setattr(background, "Recorder", defect)
    recording = BackgroundRecording(StorageOptions(str(tmp_path / "bag")), EVERYTHING, domain)
    recording.join(10)
    assert recording.error == "zbot bag recording failed: KeyError('defect')"
    assert "Traceback" in capfd.readouterr().err


def test_a_recording_that_does_not_end_is_not_waited_for(
    domain: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    may_end, stop = threading.Event(), Recorder.stop

    def stop_late(recorder: Any) -> None:
        assert may_end.wait(60)
        stop(recorder)

    monkeypatch.setattr(Recorder, "stop", stop_late)
    monkeypatch.setattr(background, "_STOP_S", 0.1)
    recording = BackgroundRecording(StorageOptions(str(tmp_path / "bag")), EVERYTHING, domain)
    recording.stop()
    assert recording.error == "zbot bag recording has not ended within 0.1 s"
    may_end.set()
    assert wait_until(lambda: not recording.is_running, 10)


def test_a_type_whose_definition_comes_late_does_not_stop_the_recording(
    domain: int, tmp_path: Path, make_context: MakeContext, monkeypatch: pytest.MonkeyPatch
) -> None:
    name, asked, may_answer = "late_robot/msg/Text", [], threading.Event()

    def answer_late(*arguments: Any, **_options: Any) -> list[Any]:
        asked.append(arguments[-1])
        assert may_answer.wait(60)
        return [parse(name, "int32 number\n")]

    monkeypatch.setattr(types, "request_definitions", answer_late)
    node = zbot.Node("robot", context=make_context())
    graph, profile = node.context.graph, zbot.QoSProfile(depth=1)
    announcement = graph.announce(
        node.handle.named_endpoint(EntityKind.PUBLISHER, "/text", (name, "RIHS01_0"), profile)
    )
    recording = BackgroundRecording(StorageOptions(str(tmp_path / "bag")), EVERYTHING, domain)
    assert wait_until(lambda: asked == [name])
    chatter = node.create_publisher(String, "chatter", 1)
    assert wait_until(lambda: chatter.get_subscription_count() == 1)
    may_answer.set()
    assert wait_until(lambda: bool(graph.snapshot().subscriptions("/text")))
    recording.stop()
    announcement.undeclare()
    assert asked == [name]
