"""The rules of the teacher's hub, enforced by real Zenoh routers."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

import pytest
import zenoh

from tests.classroom.recording_proxy import RecordingProxy
from tests.classroom.talk import HERE, Talk, accepts, answers, dialling, free_port, open_session
from tests.conftest import wait_until
from zbot.security.access import (
    LOBBY,
    LOBBY_SECRET,
    MAX_MESSAGE_SIZE,
    Share,
    accepted_users,
    credentials,
    teacher_access,
)
from zbot.security.secret import Secret, write_private

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

STUDENTS = {"17": 17, "18": 18}
_ADMISSION_KEY = "@class/lobby/door"


class Room(Talk):
    """A teacher's hub with its users."""

    def __init__(self, folder: Path, **rules: Any) -> None:
        self.port = free_port()
        self.secrets = {user: Secret.random() for user in ("teacher", *STUDENTS)}
        self.secrets[LOBBY] = LOBBY_SECRET
        self._folder = folder
        self._opened: list[zenoh.Session] = []
        write_private(folder / "all", accepted_users(self.secrets))
        self.hub = self._open(
            {
                "mode": "router",
                "listen/endpoints": [f"tcp/{HERE}:{self.port}"],
                **credentials("teacher", self.secrets["teacher"], folder / "all"),
                **teacher_access(STUDENTS, **rules),
            }
        )
        super().__init__(self.hub)

    def _open(self, paths: dict[str, Any]) -> zenoh.Session:
        self._opened.append(open_session(paths))
        return self._opened[-1]

    def client(self, user: str, port: int | None = None) -> zenoh.Session:
        """Open a session that dials a hub directly."""
        known = credentials(user, self.secrets[user])
        session = self._open(dialling(port or self.port, known))
        return self.add(session, STUDENTS.get(user, 0))

    def lobby_user(self) -> zenoh.Session:
        """Open a session of a user who has not joined."""
        session = self._open(dialling(self.port, credentials(LOBBY, LOBBY_SECRET)))
        self.hub.declare_queryable(
            _ADMISSION_KEY, lambda query: query.reply(_ADMISSION_KEY, b""), complete=True
        )
        assert wait_until(partial(answers, session, _ADMISSION_KEY))
        return session

    def laptop(self, user: str, dialled: int | None = None) -> zenoh.Session:
        """Open a session behind a hub of its own, as on a joined laptop."""
        port, accepted = free_port(), self._folder / user
        write_private(accepted, accepted_users({user: self.secrets[user]}))
        hub = {
            "mode": "router",
            "listen/endpoints": [f"tcp/{HERE}:{port}"],
            **credentials(user, self.secrets[user], accepted),
        }
        self._open({**dialling(dialled or self.port), **hub})
        return self.client(user, port)

    def close(self) -> None:
        for session in reversed(self._opened):
            session.close()


@pytest.fixture
def room(tmp_path: Path) -> Iterator[Room]:
    made = Room(tmp_path)
    yield made
    made.close()


OWN, FOREIGN = "17/x", "18/x"


def test_student_and_teacher_talk_in_the_students_domain(room: Room) -> None:
    laptop, teacher = room.laptop("17"), room.client("teacher")
    assert room.hears(teacher, laptop, OWN)
    assert room.hears(laptop, teacher, OWN)
    assert room.reaches(teacher, laptop, OWN)
    assert room.reaches(laptop, teacher, OWN)
    assert room.sees(teacher, laptop, "@zbot/17/a/0/0/NN/%/%/x")
    assert room.sees(laptop, teacher, "@zbot/17/a/0/0/NN/%/%/x")


@pytest.fixture(params=["behind a hub", "dialling directly"])
def student(request: pytest.FixtureRequest, room: Room) -> zenoh.Session:
    """Return student 17: as a joined laptop, and as a program that dials the teacher itself."""
    return room.laptop("17") if request.param == "behind a hub" else room.client("17")


@pytest.mark.parametrize(
    "key",
    [
        "18/x",
        "18/x/@adv/pub/a/0/_",
        "class/x",
        "@class/student/18/x",
        "@class/teacher/say",
        "@class/lobby/join",
        "0/x",
        "170/x",
        "1",
        "@ros2_lv/17/x",
    ],
)
def test_a_student_cannot_publish_outside_its_own_space(
    room: Room, student: zenoh.Session, key: str
) -> None:
    teacher, other = room.client("teacher"), room.laptop("18")
    assert not room.hears(teacher, student, key)
    assert not room.hears(other, student, key)
    assert not room.reaches(teacher, student, key)
    assert not room.sees(teacher, student, key)
    assert room.hears(teacher, student, OWN)


@pytest.mark.parametrize("key", ["18/x", "@class/student/18/x", "18/x/@adv/pub/a/0/_", "0/x"])
def test_a_student_receives_nothing_from_others(
    room: Room, student: zenoh.Session, key: str
) -> None:
    teacher, other = room.client("teacher"), room.laptop("18")
    for speaker in (teacher, other):
        assert not room.hears(student, speaker, key)
        assert not room.reaches(student, speaker, key)
        assert not room.sees(student, speaker, key)
    assert room.hears(student, teacher, OWN)


def test_not_even_the_names_of_foreign_topics_reach_a_laptop(room: Room) -> None:
    wire = RecordingProxy(room.port)
    room.laptop("17", wire.port)
    other = room.laptop("18")
    declared: list[Any] = [
        other.liveliness().declare_token("@zbot/18/a/0/0/NN/%/%/diary"),
        other.declare_subscriber("18/diary", zenoh.handlers.FifoChannel(10)),
        other.declare_queryable("18/diary", zenoh.handlers.FifoChannel(10)),
    ]
    room.settle()
    assert b"ping" in wire.came
    assert b"diary" not in wire.came
    for token in declared:
        token.undeclare()
    wire.close()


@pytest.mark.parametrize("key", ["**", "*/x", "18/**", "@class/student/**", "@/**", "@zbot/**"])
def test_a_wide_declaration_grants_nothing_more(
    room: Room, student: zenoh.Session, key: str
) -> None:
    teacher, other = room.client("teacher"), room.laptop("18")
    wide = student.declare_subscriber(key, zenoh.handlers.FifoChannel(10))
    asked: list[str] = []
    served = student.declare_queryable(key, lambda query: asked.append(str(query.key_expr)))
    watcher = student.liveliness().declare_subscriber(key, zenoh.handlers.FifoChannel(10))
    token = other.liveliness().declare_token("@zbot/18/a/0/0/NN/%/%/x")
    assert room.hears(teacher, other, FOREIGN)
    assert room.reaches(teacher, other, FOREIGN)
    assert wide.try_recv() is None
    assert not [key for key in asked if not key.startswith("17/ping")]
    assert watcher.try_recv() is None
    served.undeclare()
    token.undeclare()


def test_students_receive_what_the_teacher_publishes(room: Room) -> None:
    laptop, teacher = room.laptop("17"), room.client("teacher")
    for key in ("class/x", "@class/teacher/say"):
        assert room.hears(laptop, teacher, key)
        assert room.reaches(laptop, teacher, key)
        assert room.sees(laptop, teacher, key)


def test_a_student_can_publish_facts_about_its_laptop(room: Room) -> None:
    laptop, teacher = room.laptop("17"), room.client("teacher")
    key = "@class/student/17/x"
    assert room.hears(teacher, laptop, key)
    assert room.reaches(teacher, laptop, key)
    assert room.sees(teacher, laptop, key)
    assert not room.hears(laptop, teacher, key)


def test_students_can_publish_in_an_open_shared_space(tmp_path: Path) -> None:
    room = Room(tmp_path, shared_is_open=True)
    laptop, other = room.laptop("17"), room.laptop("18")
    assert room.hears(other, laptop, "class/x")
    assert room.reaches(other, laptop, "class/x")
    assert not room.hears(other, laptop, FOREIGN)
    room.close()


def test_a_share_lets_its_reader_read_and_not_write(tmp_path: Path) -> None:
    room = Room(tmp_path, shares=[Share(domain=18, reader="17")])
    laptop, other = room.laptop("17"), room.laptop("18")
    assert room.hears(laptop, other, FOREIGN)
    assert room.reaches(laptop, other, FOREIGN)
    assert room.sees(laptop, other, "@zbot/18/a/0/0/NN/%/%/x")
    assert not room.hears(other, laptop, FOREIGN)
    assert not room.hears(other, laptop, OWN)
    room.close()


@pytest.mark.parametrize("words", ["18 with the secret of 17", "nobody", "no name"])
def test_a_hub_rejects_a_wrong_secret(room: Room, words: str) -> None:
    known = credentials("17", room.secrets["17"])
    given: dict[str, Any] = {
        "18 with the secret of 17": known | {"transport/auth/usrpwd/user": "18"},
        "nobody": known | {"transport/auth/usrpwd/user": "nobody"},
        "no name": {},
    }[words]
    assert not accepts(room.port, given)
    assert accepts(room.port, known)


def test_an_oversize_sample_is_dropped_and_the_hub_continues(room: Room) -> None:
    laptop, teacher = room.laptop("17"), room.client("teacher")
    subscriber = teacher.declare_subscriber(OWN, zenoh.handlers.FifoChannel(10))
    room.settle()
    laptop.put(OWN, b"x" * (MAX_MESSAGE_SIZE + 1))
    assert wait_until(lambda: room.hears(teacher, laptop, OWN), 20)
    sizes = [len(sample.payload) for sample in iter(subscriber.try_recv, None)]
    assert MAX_MESSAGE_SIZE + 1 not in sizes


def test_a_lobby_user_can_only_query_the_lobby(room: Room) -> None:
    key, lobby_user = "@class/lobby/join", room.lobby_user()
    teacher, other = room.client("teacher"), room.laptop("17")
    assert room.reaches(lobby_user, room.hub, key)
    for forbidden in (key, "class/x", "17/x", "0/x", "@class/teacher/say", "@class/student/17/x"):
        for listener in (teacher, other):
            assert not room.hears(listener, lobby_user, forbidden)
            assert not room.hears(lobby_user, listener, forbidden)
            assert not room.reaches(listener, lobby_user, forbidden)
            assert not room.sees(listener, lobby_user, forbidden)
            assert not room.sees(lobby_user, listener, forbidden)
            assert forbidden == key or not room.reaches(lobby_user, listener, forbidden)
