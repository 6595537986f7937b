"""Tests of `zbot class record` with a class that does not always answer."""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest

from zbot.bag.errors import BagError
from zbot.classroom.errors import ClassCommandError
from zbot_cli.commands.class_ import recording
from zbot_cli.commands.class_.recording import ClassRecording

if TYPE_CHECKING:
    from pathlib import Path

ANA, BEN = {"number": 17, "name": "Ana"}, {"number": 18, "name": "Ben"}
SILENT = ClassCommandError("the class does not answer: try again")
SLOW = BagError("zbot bag recording has not started within 20 s")


class Lesson:
    """Class, and recordings of its students. Ctrl-C comes after the last answer of the class."""

    def __init__(self, answers: list[Any], failures: list[BagError]) -> None:
        self.answers, self.failures = answers, failures
        self.events: list[str] = []

    def command(self, _question: dict[str, str]) -> dict[str, Any]:
        """Return the next list of students, or raise the next error."""
        answer = self.answers.pop(0)
        if isinstance(answer, Exception):
            raise answer
        return {"students": answer}

    def sleep(self, _seconds: float) -> None:
        """Do not sleep."""
        if not self.answers:
            raise KeyboardInterrupt

    def begin(self, _storage: Any, _options: Any, number: int, *, is_client: bool) -> Recording:
        """Begin to record a student, or raise the next error."""
        assert is_client
        if self.failures:
            raise self.failures.pop(0)
        self.events.append(f"begin {number}")
        return Recording(self.events)


class Recording:
    """Recording that only notes its end."""

    error = ""

    def __init__(self, events: list[str]) -> None:
        self._events = events

    def end(self) -> None:
        self._events.append("end")

    def stop(self) -> None:
        self._events.append("stop")


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(recording, "import_mcap", lambda: None)
    monkeypatch.setattr(recording, "install", lambda *, calls_ok: calls_ok)
    return tmp_path / "recorded"


def record(
    folder: Path, monkeypatch: pytest.MonkeyPatch, answers: list[Any], *failures: BagError
) -> list[str]:
    """Record a class. Return what happened to the recordings."""
    lesson = Lesson(answers, list(failures))
    monkeypatch.setattr(recording, "command", lesson.command)
    monkeypatch.setattr(recording, "BackgroundRecording", lesson.begin)
    monkeypatch.setattr(recording, "time", SimpleNamespace(sleep=lesson.sleep))
    ClassRecording(folder, (), (), 0).run()
    return lesson.events


def test_a_class_that_does_not_answer_is_recorded_on(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    events = record(folder, monkeypatch, [[ANA], SILENT, SILENT, [ANA, BEN], SILENT])
    assert events == ["begin 17", "begin 18", "end", "end", "stop", "stop"]
    assert capsys.readouterr().err == f"{SILENT}\n" * 2  # once each time that it falls silent


def test_a_recording_that_does_not_start_is_tried_again(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    events = record(folder, monkeypatch, [[ANA], [ANA], [ANA]], SLOW, SLOW)
    assert events == ["begin 17", "end", "stop"]
    assert capsys.readouterr().err == f" 17  {SLOW}\n"
