from __future__ import annotations

from dataclasses import asdict
from typing import Any

import pytest

from zbot.classroom.join_request import JoinRequest, proof
from zbot.classroom.teacher.join_service import JoinService
from zbot.classroom.teacher.student_list import StudentList
from zbot.security.pin import PinClient, PinError
from zbot.security.secret import Secret

Document = dict[str, Any]

HUB = "tcp/10.0.0.1:7447"


def make_client(pin: str = "", hub: str = HUB) -> PinClient:
    return PinClient(Secret(pin), "Robots", hub)


class Class:
    """Class and a client that joins it."""

    def __init__(self, pin: str = "") -> None:
        self.students = StudentList("master", {3: "Ana"})
        self.changed: list[int] = []
        self.service = JoinService(
            "Robots",
            pin,
            self.students,
            is_own_hub=lambda hub: hub == HUB,
            credentials=lambda number: {"secret": f"s{number}"},
            changed=self.changed.append,
        )

    def request_admission(self, request: JoinRequest, pin: str = "") -> Document:
        client = make_client(pin)
        challenge = self.service.answer({"op": "enrol", **client.hello()})
        sealed = self.service.answer({"op": "claim", **client.claim(challenge, asdict(request))})
        return sealed if "refused" in sealed else client.opened(sealed)


def test_hello_returns_the_class_name() -> None:
    answer = Class("1234").service.answer({"op": "hello"})
    assert (answer["class"], answer["pin"]) == ("Robots", True)
    assert not Class().service.answer({"op": "hello"})["pin"]


def test_a_laptop_gets_a_number_and_its_credentials() -> None:
    lesson = Class("1234")
    given = lesson.request_admission(JoinRequest("m1", "laptop", "Cem", 17), "1234")
    assert given["number"] == 17
    assert given["name"] == "Cem"
    assert given["secret"] == "s17"
    assert lesson.changed == [17]


def test_a_laptop_that_dialled_another_machine_gets_a_sentence() -> None:
    hello = make_client("1234", hub="tcp/10.0.0.66:7447").hello()
    answer = Class("1234").service.answer({"op": "enrol", **hello})
    assert answer["refused"] == "question"
    assert "did not dial the class's own machine" in answer["sentence"]


def test_an_older_laptop_gets_a_sentence() -> None:
    answer = Class("1234").service.answer({"op": "enrol", "public": "ab" * 384})
    assert answer["refused"] == "question"
    assert answer["sentence"].startswith("zbot on this laptop is older than zbot of the class:")


def test_a_wrong_pin_is_refused_and_claims_no_number() -> None:
    lesson = Class("1234")
    assert lesson.request_admission(JoinRequest("m1", "laptop"), "1111")["refused"] == "pin"
    assert not lesson.students.students()


def test_a_taken_number_is_refused_with_the_holders_name() -> None:
    lesson = Class()
    lesson.request_admission(JoinRequest("m1", "laptop", "Cem", 17))
    answer = lesson.request_admission(JoinRequest("m2", "laptop", "Eve", 17))
    assert answer["refused"] == "taken"
    assert "Cem" in answer["sentence"]


def test_a_number_out_of_range_is_refused() -> None:
    assert (
        "from 1 to 232"
        in Class().request_admission(JoinRequest("m1", "laptop", number=999))["sentence"]
    )


def test_a_claim_cannot_be_used_twice() -> None:
    lesson = Class()
    client = make_client()
    challenge = lesson.service.answer({"op": "enrol", **client.hello()})
    claim = {"op": "claim", **client.claim(challenge, asdict(JoinRequest("m1", "laptop")))}
    client.opened(lesson.service.answer(claim))
    assert "refused" in lesson.service.answer(claim)


def test_a_claim_is_bound_to_its_proof() -> None:
    lesson = Class()
    client = make_client()
    challenge = lesson.service.answer({"op": "enrol", **client.hello()})
    claim = client.claim(challenge, asdict(JoinRequest("m1", "laptop", number=17)))
    claim["claim"] = claim["claim"][:-2] + ("00" if claim["claim"][-2:] != "00" else "01")
    assert "refused" in lesson.service.answer({"op": "claim", **claim})


def test_only_the_holder_can_return_a_number() -> None:
    lesson = Class()
    given = lesson.request_admission(JoinRequest("m1", "laptop", number=17))
    stolen = {"op": "release", "number": 17, "proof": proof("guess", "release")}
    assert lesson.service.answer(stolen) == {"released": False}
    assert lesson.students.student(17) is not None
    honest = {"op": "release", "number": 17, "proof": proof(given["claim"], "release")}
    assert lesson.service.answer(honest) == {"released": True}
    assert lesson.service.answer(honest) == {"released": False}


def test_guesses_are_delayed() -> None:
    lesson = Class("1234")
    server = lesson.service._pin_server
    server._now = lambda: server._counted  # all guesses come at once
    answers = []
    for number in range(20):
        try:
            answers.append(lesson.request_admission(JoinRequest("m", "laptop"), f"{number:04}"))
        except PinError as error:
            answers.append({"refused": type(error).__name__})
    kinds = [answer["refused"] for answer in answers]
    assert kinds[:5] == ["pin"] * 5
    assert set(kinds[12:]) != {"pin"}


@pytest.mark.parametrize(
    "question",
    [
        {},
        {"op": "claim"},
        {"op": "enrol"},
        {"op": "enrol", "public": "0"},
        {"op": "enrol", "public": ["x"]},
        {"op": "claim", "visit": {}, "claim": 7, "proof": None},
        {"op": "release", "number": "17"},
        {"op": "release", "number": True, "proof": "x"},
        {"op": ["hello"]},
        {"op": "list"},
    ],
)
def test_an_invalid_request_is_answered_and_changes_nothing(question: Document) -> None:
    lesson = Class()
    answer = lesson.service.answer(question)
    assert answer.get("refused") or answer.get("released") is False
    assert not lesson.students.students()


def test_an_invalid_request_is_sanitized() -> None:
    read = JoinRequest.of({"machine": "x" * 1000, "host": "\x1b[1m", "name": 7, "number": "17"})
    assert len(read.machine) <= 64
    assert read.host == "[1m"
    assert read.name == "7"
    assert read.number is None
