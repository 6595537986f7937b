"""The class in the teacher's process, without a network."""

from __future__ import annotations

from dataclasses import asdict
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest

from zbot.classroom.join_request import JoinRequest, proof
from zbot.classroom.teacher import student_list
from zbot.classroom.teacher.class_record import ClassRecord
from zbot.classroom.teacher.running_class import RunningClass
from zbot.classroom.teacher.student_list import StudentList
from zbot.security.pin import PinClient
from zbot.security.secret import Secret

if TYPE_CHECKING:
    from pathlib import Path


class Hub:
    """Stands for the hub's process."""

    def __init__(self) -> None:
        self.reopenings = 0
        self.session = SimpleNamespace(info=SimpleNamespace(transports=list))

    def reopen(self) -> None:
        self.reopenings += 1


class Lesson:
    """Class without a PIN, and laptops that join it."""

    def __init__(self) -> None:
        self.hub = Hub()
        self.record = ClassRecord("Robots", StudentList("master"))
        self.room = RunningClass(self.record, 7447)
        self.room._serving = self.room._commands._serving = self.hub  # type: ignore[assignment]

    def join(self, machine: str, number: int | None = None, name: str = "Ana") -> dict[str, Any]:
        """Ask for admission, and return the answer."""
        client = PinClient(Secret(""), "Robots", "hub")
        challenge = self.ask({"op": "enrol", **client.hello()})
        request = asdict(JoinRequest(machine, "laptop", name, number))
        sealed = self.ask({"op": "claim", **client.claim(challenge, request)})
        return sealed if "refused" in sealed else client.opened(sealed)

    def ask(self, question: dict[str, Any]) -> dict[str, Any]:
        return self.room._answer_lobby(question)

    def confirm(self, given: dict[str, Any]) -> dict[str, Any]:
        """Ask as a laptop whose hub is linked."""
        question = {"number": given["number"], "proof": proof(given["claim"], "nodes")}
        return self.room._answer_student(question)

    def leave(self, given: dict[str, Any]) -> None:
        proven = proof(given["claim"], "release")
        released = self.ask({"op": "release", "number": given["number"], "proof": proven})
        assert released == {"released": True}

    @property
    def numbers(self) -> list[int]:
        return [student.number for student in self.record.students.students()]


@pytest.fixture
def lesson(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Lesson:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    return Lesson()


def test_a_number_that_changes_hands_does_not_reopen_the_hub(lesson: Lesson) -> None:
    ids = set()
    for turn in range(9):
        given = lesson.join(f"laptop {turn}", 7)
        ids.add(given["hub_id"])
        lesson.leave(given)
    assert len(ids) == 9
    assert lesson.hub.reopenings == 0


def test_a_laptop_waits_while_the_hub_reopens_for_it(lesson: Lesson) -> None:
    given: dict[str, Any] = {}
    for turn in range(10):
        given = lesson.join(f"laptop {turn}", 7)
        if "refused" not in given:
            lesson.leave(given)
    assert given["refused"] == "wait"
    assert given["wait_s"] > 0
    assert lesson.hub.reopenings == 1
    lesson.room.settings()  # as when the hub is opened
    assert lesson.join("laptop 9", 7)["number"] == 7
    assert lesson.numbers == [7]


def test_a_laptop_that_asks_again_gets_the_same_number_and_id(lesson: Lesson) -> None:
    first, second = lesson.join("laptop"), lesson.join("laptop")
    assert (first["number"], first["hub_id"]) == (second["number"], second["hub_id"])
    assert lesson.numbers == [1]


def test_a_laptop_that_was_never_linked_loses_its_number(
    lesson: Lesson, monkeypatch: pytest.MonkeyPatch
) -> None:
    lesson.confirm(lesson.join("linked"))
    lesson.join("never linked")
    assert lesson.numbers == [1, 2]
    monkeypatch.setattr(student_list, "_JOINING_S", 0.0)
    lesson.ask({"op": "hello"})
    assert lesson.numbers == [1]


def test_a_former_owner_that_connects_reopens_the_hub(lesson: Lesson) -> None:
    given = lesson.join("first", 7)
    lesson.leave(given)
    other = lesson.join("second", 7)
    lesson.room._reject_former({other["hub_id"]})
    assert lesson.hub.reopenings == 0
    lesson.room._reject_former({given["hub_id"]})
    assert lesson.hub.reopenings == 1


def test_only_the_owner_is_a_member(lesson: Lesson) -> None:
    given = lesson.join("first", 7)
    question = {"op": "member", "number": 7, "proof": proof(given["claim"], "member")}
    assert lesson.ask(question) == {"member": True}
    assert lesson.ask({**question, "proof": proof("guess", "member")}) == {"member": False}
    lesson.leave(given)
    assert lesson.ask(question) == {"member": False}


def test_students_with_the_same_name_are_told(lesson: Lesson) -> None:
    ana, cem = lesson.join("first"), lesson.join("second", name="Cem")
    other = lesson.join("third", name="ana")
    assert lesson.confirm(ana)["namesakes"] == [other["number"]]
    assert lesson.confirm(other)["namesakes"] == [ana["number"]]
    assert lesson.confirm(cem)["namesakes"] == []


def test_a_freed_number_says_whose_it_was(lesson: Lesson) -> None:
    lesson.join("first", 7)
    told = lesson.room._commands.answer({"op": "free", "number": 7})
    assert told == {"freed": 7, "name": "Ana", "host": "laptop", "here": False}
    assert lesson.hub.reopenings == 1
    assert (
        "no student has number 7"
        in lesson.room._commands.answer({"op": "free", "number": 7})["error"]
    )
