"""Attacks that try to get access without permission."""

from __future__ import annotations

import contextlib
import json
import os
import socket
import stat
from pathlib import Path
from typing import Any

import psutil
import pytest
import zenoh

from tests.classroom.attacked import PIN, AttackedClass
from tests.classroom.talk import HERE, accepts, dialling, open_session
from zbot.classroom.keys import ADMISSION_KEY, COMMAND_KEY, NOTICES_KEY, facts_key, here_key
from zbot.log.teacher_notice import NOTICE_KEY
from zbot.security.access import credentials
from zbot.security.secret import Secret

SECRET_FILES = ("membership.json", "users.txt", "class.json", "machine", "hub.log", "hub.json")


# -- other people's domains ------------------------------------------------------------------------


def test_read_a_foreign_domain(room: AttackedClass, ben: zenoh.Session) -> None:
    talk = room.talk
    wide = [
        ben.declare_subscriber(key, zenoh.handlers.FifoChannel(100))
        for key in ("**", "17/**", "*/work", "17/**/@adv/**", "@class/**")
    ]
    for key in ("17/work", "17/work/@adv/pub/a/0/_", here_key(17), COMMAND_KEY, "0/work"):
        for speaker in (room.honest, room.teacher_session):
            assert not talk.hears(ben, speaker, key)
            assert not talk.reaches(ben, speaker, key)
            assert not talk.sees(ben, speaker, key)
    assert not talk.sees(ben, room.honest, "@zbot/17/a/0/0/NN/%/%/node")
    heard = {
        str(sample.key_expr) for subscriber in wide for sample in iter(subscriber.try_recv, None)
    }
    assert not {key for key in heard if not key.startswith("18/")}
    for subscriber in wide:
        subscriber.undeclare()


def test_write_a_foreign_domain(room: AttackedClass, ben: zenoh.Session) -> None:
    talk = room.talk
    for key in ("17/work", "17/work/@adv/pub/a/0/_", facts_key(17), "class/demo", "0/work"):
        for listener in (room.honest, room.teacher_session):
            assert not talk.hears(listener, ben, key)
            assert not talk.reaches(listener, ben, key)
            assert not talk.sees(listener, ben, key)
    assert not talk.sees(room.teacher_session, ben, "@zbot/17/a/0/0/NN/%/%/forged")
    assert not talk.sees(room.teacher_session, ben, here_key(17) + "/forged")


def test_deletes_and_wildcard_puts_reach_nobody(room: AttackedClass, ben: zenoh.Session) -> None:
    listeners = [
        session.declare_subscriber("17/**", zenoh.handlers.FifoChannel(100))
        for session in (room.honest, room.teacher_session)
    ]
    room.talk.settle()
    for key in ("17/work", "**", "17/**", "*/work", "1*/work".replace("*", "$*")):
        ben.delete(key)
        ben.put(key, b"x")
    room.talk.settle()
    assert [listener.try_recv() for listener in listeners] == [None, None]
    for listener in listeners:
        listener.undeclare()


def test_impersonate_the_teacher(
    room: AttackedClass, ben: zenoh.Session, lobby_user: zenoh.Session
) -> None:
    talk = room.talk
    for key in (NOTICE_KEY, NOTICES_KEY, COMMAND_KEY, ADMISSION_KEY, "class/demo"):
        assert not talk.hears(room.honest, ben, key)
        assert not talk.hears(room.teacher_session, ben, key)
    # Answers of his own to what others ask the teacher.
    forged = [
        ben.declare_queryable(key, lambda query: query.reply(query.key_expr, b'{"forged": 1}'))
        for key in (NOTICES_KEY, ADMISSION_KEY, COMMAND_KEY, facts_key(17), "@class/**", "**")
    ]
    talk.settle()
    for asking, key in (
        (room.honest, NOTICES_KEY),
        (lobby_user, ADMISSION_KEY),
        (room.teacher_session, COMMAND_KEY),
        (room.teacher_session, facts_key(17)),
    ):
        told = [reply.ok.payload.to_bytes() for reply in asking.get(key, timeout=20) if reply.ok]
        assert told
        assert b"forged" not in b"".join(told)
    for token in forged:
        token.undeclare()


def test_send_the_teachers_commands(room: AttackedClass, ben: zenoh.Session) -> None:
    for question in ({"op": "list"}, {"op": "free", "number": 17}, {"op": "open", "on": True}):
        replies = list(ben.get(COMMAND_KEY, payload=json.dumps(question), timeout=2))
        assert not [reply for reply in replies if reply.ok]
    assert room.ben.run("class", "list").code == 1
    assert room.ben.run("class", "free", "17").code == 1
    assert room.listed()[17]["name"] == "Ana"


def test_a_router_of_a_students_own_has_the_students_rights_only(
    room: AttackedClass, guest: zenoh.Session, lobby_user: zenoh.Session
) -> None:
    assert room.talk.hears(room.teacher_session, guest, "18/work")
    assert room.talk.hears(guest, room.teacher_session, "18/work")
    test_read_a_foreign_domain(room, guest)
    test_write_a_foreign_domain(room, guest)
    test_deletes_and_wildcard_puts_reach_nobody(room, guest)
    test_impersonate_the_teacher(room, guest, lobby_user)
    assert room.listed()[17]["name"] == "Ana"


# -- the network port ------------------------------------------------------------------------------


@pytest.mark.parametrize("who", ["nobody", "wrong secret", "Ben as Ana", "unknown", "lobby as Ana"])
def test_connect_without_credentials_or_with_wrong_ones(room: AttackedClass, who: str) -> None:
    own = room.ben.credentials
    ana = {"transport/auth/usrpwd/user": room.ana.membership["user"]}
    given: dict[str, dict[str, Any]] = {
        "nobody": {},
        "wrong secret": credentials("student18", Secret("wrong")),
        "Ben as Ana": own | ana,
        "unknown": credentials("eve", Secret("eve")),
        "lobby as Ana": credentials(ana["transport/auth/usrpwd/user"], Secret("lobby")),
    }
    assert not accepts(room.port, given[who])


def test_a_student_laptop_accepts_no_connections(room: AttackedClass) -> None:
    for paths in ({}, room.ben.credentials, credentials("lobby", Secret("lobby"))):
        assert not accepts(room.ana.port, paths)
    links = psutil.net_connections("tcp")
    listening = [tuple(link.laddr) for link in links if link.status == psutil.CONN_LISTEN]
    assert {ip for ip, port in listening if port == room.ana.port} == {"127.0.0.1"}


def test_a_thousand_half_open_connections(room: AttackedClass) -> None:
    with contextlib.ExitStack() as stack:
        for _ in range(1000):
            stack.enter_context(socket.create_connection((HERE, room.port), 5))
        room.check_honest_work()
        late = room.student("gina", 42)
    late.do("leave")


@pytest.mark.parametrize(
    "sent",
    [
        b"GET / HTTP/1.1\r\n\r\n",
        b"\x00" * 1000,
        b"\xff" * 70_000,
        b"\x16\x03\x01\x02\x00\x01\x00",
        bytes(range(256)) * 16,
    ],
    ids=["http", "zeros", "ones", "tls", "counting"],
)
def test_send_nonsense_to_the_port(room: AttackedClass, sent: bytes) -> None:
    for _ in range(20):
        with socket.create_connection((HERE, room.port), 5) as plain, contextlib.suppress(OSError):
            plain.sendall(sent)
            plain.shutdown(socket.SHUT_WR)
            while plain.recv(1000):
                pass


def test_take_the_session_id_of_the_hub(room: AttackedClass) -> None:
    hub = next(iter(room.teacher_session.info.routers_zid()))
    honest = room.honest.info.zid()
    for zid in (hub, honest):
        with contextlib.suppress(zenoh.ZError):
            twin = open_session(
                {**dialling(room.port, room.ben.credentials), "mode": "router", "id": str(zid)}
                | {"listen/endpoints": []}
            )
            twin.put("17/work", b"x")
            twin.close()


# -- the admin space and secrets -------------------------------------------------------------------


def test_read_and_write_the_admin_space(room: AttackedClass, ben: zenoh.Session) -> None:
    hub = next(iter(room.teacher_session.info.routers_zid()))
    for key in (f"@/{hub}/router/**", "@/**", f"@/{hub}/router/config/**"):
        found = [str(reply.ok.key_expr) for reply in ben.get(key, timeout=2) if reply.ok]
        assert not [key for key in found if key.startswith(f"@/{hub}")]
    for value in ("false", '{"enabled": false}'):
        for key in (f"@/{hub}/router/config/access_control", f"@/{hub}/router/config/**"):
            ben.put(key, value)
            room.teacher_session.put(key, value)  # nor may the teacher's own tools
    room.talk.settle()
    assert not room.talk.hears(room.honest, ben, "17/work")


def test_no_secret_is_in_the_admin_space_even_for_the_teacher(room: AttackedClass) -> None:
    secrets = [
        computer.membership["secret"].encode() for computer in (room.teacher, room.ana, room.ben)
    ]
    for session in (room.teacher_session, room.honest):
        told = b"".join(
            reply.ok.payload.to_bytes() for reply in session.get("@/**", timeout=3) if reply.ok
        )
        assert told
        assert not [secret for secret in [*secrets, PIN.encode()] if secret in told]


@pytest.mark.skipif(not Path("/proc/self/cmdline").exists(), reason="needs /proc")
def test_no_secret_is_on_a_command_line_or_in_a_log(room: AttackedClass) -> None:
    everybody = (room.teacher, room.ana, room.ben)
    secrets = [computer.membership["secret"].encode() for computer in everybody]
    lines = b""
    for process in Path("/proc").glob("[0-9]*/cmdline"):
        with contextlib.suppress(OSError):
            lines += process.read_bytes()
    logs = b"".join((computer.folder / "zbot" / "hub.log").read_bytes() for computer in everybody)
    assert b"zbot.classroom" in lines
    assert not [secret for secret in [*secrets, PIN.encode()] if secret in lines + logs]


@pytest.mark.skipif(os.name == "nt", reason="Windows has no file modes")
def test_secret_files_are_readable_by_their_owner_only(room: AttackedClass) -> None:
    for computer in (room.teacher, room.ana):
        folder = computer.folder / "zbot"
        assert stat.S_IMODE(folder.stat().st_mode) == 0o700
        found = [folder / name for name in SECRET_FILES if (folder / name).exists()]
        assert len(found) >= 4
        assert {stat.S_IMODE(path.stat().st_mode) for path in found} == {0o600}
