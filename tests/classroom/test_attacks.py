"""Attacks on a class, by a student or by a program in the network that has not joined.

Each test attacks a class that was opened with `zbot class start --pin`, with plain Zenoh sessions
and sockets. After each attack, Ana and the teacher can still work.
"""

from __future__ import annotations

import contextlib
import json
import os
import socket
import stat
import subprocess
import sys
import threading
from pathlib import Path
from typing import TYPE_CHECKING, Any

import psutil
import pytest
import zenoh

from tests.classroom.attacked import PIN, AttackedClass, Computer
from tests.classroom.talk import HERE, accepts, answers, dialling, open_session
from tests.conftest import wait_until
from zbot.classroom.keys import ADMISSION_KEY, COMMAND_KEY, NOTICES_KEY, facts_key, here_key
from zbot.log.teacher_notice import NOTICE_KEY
from zbot.security.access import MAX_MESSAGE_SIZE, credentials
from zbot.security.pin import PinClient
from zbot.security.secret import Secret

if TYPE_CHECKING:
    from collections.abc import Iterator

SECRET_FILES = ("membership.json", "users.txt", "class.json", "machine", "hub.log", "hub.json")


@pytest.fixture(scope="module")
def opened(tmp_path_factory: pytest.TempPathFactory) -> Iterator[AttackedClass]:
    made = AttackedClass(tmp_path_factory.mktemp("class"))
    yield made
    made.close()


@pytest.fixture
def room(opened: AttackedClass) -> Iterator[AttackedClass]:
    yield opened
    opened.check_honest_work()


@pytest.fixture(params=["directly", "through his own hub"])
def ben(request: pytest.FixtureRequest, room: AttackedClass) -> Iterator[zenoh.Session]:
    with room.as_ben(directly=request.param == "directly") as session:
        yield session


@pytest.fixture
def lobby_user(room: AttackedClass) -> Iterator[zenoh.Session]:
    with room.as_lobby_user() as session:
        yield session


@pytest.fixture(scope="module")
def eve(opened: AttackedClass) -> Computer:
    return opened.computer("eve")


@pytest.fixture
def raw_client(room: AttackedClass) -> Iterator[zenoh.Session]:
    with room.as_raw_client() as session:
        yield session


asked = AttackedClass.ask_admission


def claimed(session: zenoh.Session, pin: str, request: dict[str, Any]) -> dict[str, Any]:
    """Claim a number with a PIN; return the claim and its answer."""
    client = PinClient(Secret(pin))
    challenge = asked(session, {"op": "enrol", **client.hello()})
    if "refused" in challenge:
        return {"answer": challenge}
    claim = {"op": "claim", **client.claim(challenge, request)}
    return {"claim": claim, "answer": asked(session, claim)}


# -- other people's domains --------------------------------------------------------------------


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
    heard = {str(sample.key_expr) for one in wide for sample in iter(one.try_recv, None)}
    assert not {key for key in heard if not key.startswith("18/")}
    for one in wide:
        one.undeclare()


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
        one.declare_subscriber("17/**", zenoh.handlers.FifoChannel(100))
        for one in (room.honest, room.teacher_session)
    ]
    room.talk.settle()
    for key in ("17/work", "**", "17/**", "*/work", "1*/work".replace("*", "$*")):
        ben.delete(key)
        ben.put(key, b"x")
    room.talk.settle()
    assert [one.try_recv() for one in listeners] == [None, None]
    for one in listeners:
        one.undeclare()


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
        told = [reply.ok.payload.to_bytes() for reply in asking.get(key, timeout=2) if reply.ok]
        assert told
        assert b"forged" not in b"".join(told)
    for one in forged:
        one.undeclare()


def test_send_the_teachers_commands(room: AttackedClass, ben: zenoh.Session) -> None:
    for question in ({"op": "list"}, {"op": "free", "number": 17}, {"op": "open", "on": True}):
        replies = list(ben.get(COMMAND_KEY, payload=json.dumps(question), timeout=2))
        assert not [reply for reply in replies if reply.ok]
    assert room.ben.run("class", "list").code == 1
    assert room.ben.run("class", "free", "17").code == 1
    assert room.listed()[17]["name"] == "Ana"


# -- numbers and PINs --------------------------------------------------------------------------


def test_claim_a_taken_number(room: AttackedClass) -> None:
    eve = room.computer("eve1")
    refused = eve.run("join", f"{HERE}:{room.port}", "--number", "17", ZBOT_PIN=PIN)
    assert refused.code == 1
    assert refused.err.startswith("number 17 is taken by Ana: choose another")
    assert not eve.has_joined


def test_claim_a_number_with_the_name_of_its_owner(lobby_user: zenoh.Session) -> None:
    for request in (
        {"machine": "eve", "host": "x", "number": 17, "name": "Ana"},
        {"machine": "", "host": "x", "number": 17, "name": "Ana"},
        {"host": "x", "number": 17},
    ):
        answer = claimed(lobby_user, PIN, request)["answer"]
        assert answer["refused"] == "taken"
        assert "secret" not in json.dumps(answer)


def test_replay_a_claim(lobby_user: zenoh.Session) -> None:
    request = {"machine": "carl", "host": "carl-laptop", "number": 30}
    recorded = claimed(lobby_user, PIN, request)
    assert "tag" in recorded["answer"]
    again = asked(lobby_user, recorded["claim"])
    assert again["refused"] == "question"
    later = asked(lobby_user, {"op": "enrol", **PinClient(Secret(PIN)).hello()})
    spliced = asked(lobby_user, {**recorded["claim"], "visit": later["visit"]})
    assert spliced["refused"] == "pin"


def test_admission_messages_reveal_neither_pin_nor_names(lobby_user: zenoh.Session) -> None:
    # A listener on the way sees these documents; the laptop's id would make it Carl.
    request = {"machine": "0123456789abcdef", "host": "carl-laptop", "number": 31}
    seen = json.dumps(claimed(lobby_user, PIN, request))
    for word in (PIN, "0123456789abcdef", "carl", "student31"):
        assert word not in seen
        assert word.encode().hex() not in seen


def test_release_another_students_number(room: AttackedClass, ben: zenoh.Session) -> None:
    for proof in ("", "0" * 64, None, "\ud800", {"a": 1}):
        answer = asked(ben, {"op": "release", "number": 17, "proof": proof})
        assert not answer.get("released")
    assert room.listed()[17]["name"] == "Ana"


def test_a_reassigned_number_rejects_the_old_secret(room: AttackedClass) -> None:
    dora = room.student("dora", 40)
    had = dora.credentials
    room.teacher.do("class", "free", "40")
    assert wait_until(lambda: not accepts(room.port, had), 10)
    emil = room.student("emil", 40)
    # The hub is open again, with the new credentials, only when it accepts Emil.
    assert wait_until(lambda: accepts(room.port, emil.credentials), 10)
    assert not accepts(room.port, had)
    emil.do("leave")


def test_guess_the_pin(room: AttackedClass, lobby_user: zenoh.Session) -> None:
    told = [
        claimed(lobby_user, f"{number:06d}", {"machine": "eve"})["answer"] for number in range(20)
    ]
    kinds = [answer["refused"] for answer in told]
    assert kinds[0] == "pin"
    assert 0 < kinds.count("pin") <= 14  # ten are free, and one more comes in two seconds
    assert set(kinds) == {"pin", "wait"}
    assert told[kinds.index("wait")]["wait_s"] <= 2
    late = room.student("frieda", 41)  # who knows it gets in meanwhile, a little later
    late.do("leave")


@pytest.mark.parametrize(
    ("words", "sentence"),
    [("000000", "wrong PIN"), ("", "PIN"), ("4711001", "wrong PIN"), ("x" * 100_000, "wrong PIN")],
)
def test_join_with_a_wrong_pin(room: AttackedClass, words: str, sentence: str) -> None:
    eve = room.computer(f"eve{abs(hash(words))}")
    refused = eve.run("join", f"{HERE}:{room.port}", stdin=f"{words}\n")
    assert refused.code == 1
    assert sentence in refused.err
    assert len(refused.err.strip().splitlines()) == 1


# -- the network port --------------------------------------------------------------------------


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


# -- what is sent ------------------------------------------------------------------------------


def test_oversize_samples(room: AttackedClass, ben: zenoh.Session) -> None:
    subscriber = room.teacher_session.declare_subscriber("18/big", zenoh.handlers.FifoChannel(10))
    room.talk.settle()
    ben.put("18/big", b"x" * (MAX_MESSAGE_SIZE + 1))
    ben.put(facts_key(18), b"x" * (MAX_MESSAGE_SIZE + 1))
    room.check_honest_work()
    assert subscriber.try_recv() is None
    subscriber.undeclare()


@pytest.mark.parametrize(
    "payload",
    [
        b"",
        b"\xff\xfe",
        b"null",
        b"[]",
        b"1e999",
        b"{" * 100_000,
        b"[" * 100_000 + b"]" * 100_000,
        b'{"op": {"a": []}}',
        b'{"op": "claim", "visit": {}, "claim": [], "proof": 1e400}',
        b'{"op": "enrol", "public": "' + b"f" * 1_000_000 + b'"}',
        b'{"op": "release", "number": 1e999, "proof": "\\ud800"}',
        b'{"op": "release", "number": ' + b"9" * 5000 + b"}",
        b'{"a": "' + b"x" * 10_000_000 + b'"}',
    ],
    ids=lambda payload: f"{payload[:40].decode('latin-1')}{len(payload)}",
)
def test_malformed_admission_requests(lobby_user: zenoh.Session, payload: bytes) -> None:
    list(lobby_user.get(ADMISSION_KEY, payload=payload, timeout=5))
    hello = asked(lobby_user, {"op": "hello"})
    assert hello["class"] == "attacked"


@pytest.mark.parametrize(
    "facts",
    [
        b"nonsense",
        b"{" * 100_000,
        b'{"time_ns": 1' + b"0" * 400 + b"}",
        b'{"time_ns": 1e400, "version": {"a": 1}, "system": [[]]}',
        b'{"time_ns": -1, "last_error": {"node": ["x"], "text": {"a": "\\u001b[2J"}}}',
        b'{"last_error": {"node": "\\u001b[2J<script>", "text": "\\r\\n$(reboot)\\u0000"}}',
        b'{"version": "' + b"x" * 20_000_000 + b'"}',
    ],
    ids=lambda facts: f"{facts[:24].decode('latin-1')}{len(facts)}",
)
def test_malformed_facts_do_not_change_the_teachers_list(
    room: AttackedClass, raw_client: zenoh.Session, facts: bytes
) -> None:
    was_asked = threading.Event()

    def answer(query: zenoh.Query) -> None:
        was_asked.set()
        query.reply(query.key_expr, facts)

    answering = raw_client.declare_queryable(facts_key(19), answer, complete=True)
    room.talk.settle()
    shown = room.teacher.do("class", "list")
    assert was_asked.is_set()
    assert "Ana" in shown
    assert "Raw" in shown
    assert is_plain(shown)
    answering.undeclare()


TOKENS = [
    "@zbot/18/a/0/0/NN/%/%/\x1b[2Jcleared",
    "@zbot/18/a/0/0/NN/%/%/<img src=x onerror=alert(1)>",
    "@zbot/18/a/0/0/NN/%/%..%..%etc/passwd",
    "@zbot/18/a/0/0/NN/%/%/;(reboot)",
    "@zbot/18/a/x/y/NN",
    "@zbot/18/a/0/0/XX/%/%/x",
    "@zbot/18/a/0/1/MP/%/%/x/%y/%/%/%",
    "@zbot/18/a/0/1/MP/%/%/x/%y/std_msgs%msg%String/RIHS01_x/9999:::::",
    "@zbot/18/" + "/".join("x" * 100 for _ in range(640)),
    "@class/student/18/here/too",
]


def test_malformed_tokens(room: AttackedClass, ben: zenoh.Session) -> None:
    declared = [ben.liveliness().declare_token(token) for token in TOKENS]
    room.talk.settle()
    for words in (("class", "list"), ("class", "list", "--json")):
        shown = room.teacher.do(*words)
        assert "Ana" in shown
        assert is_plain(shown)
    for one in declared:
        one.undeclare()


def is_plain(shown: str) -> bool:
    """Return whether a terminal does nothing but print it."""
    return all(char.isprintable() or char == "\n" for char in shown)


def test_malformed_samples_and_attachments(room: AttackedClass, ben: zenoh.Session) -> None:
    encoding = "application/msgpack;rcl_interfaces/msg/Log"
    for payload in (
        b"",
        b"\xc1",
        b"\x81",
        b"\xdf\xff\xff\xff\xff",
        b"\x81\xa3msg\xdb\xff\xff\xff\xff",
    ):
        for attachment in (None, b"", b"x", b"\xff" * 33, b"x" * 100_000):
            ben.put("18/rosout", payload, encoding=encoding, attachment=attachment)
    for key in ("18/rosout", here_key(18), facts_key(18), "@zbot/18/x"):
        ben.put(key, b"\x80", encoding="x" * 200)
        ben.delete(key)
    assert wait_until(lambda: 18 in room.listed())


BREAKING = """
import json, sys, zenoh
paths, what = json.load(sys.stdin)
config = zenoh.Config()
for path, value in paths.items():
    config.insert_json5(path, json.dumps(value))
session = zenoh.open(config)
long = "18/" + "/".join("x" * 100 for _ in range(700))
if what == "key":
    session.put(long, b"x")
elif what == "token":
    session.liveliness().declare_token(long)
elif what == "encoding":
    session.put("18/x", b"x", encoding="x" * 100_000)
"""


@pytest.mark.parametrize("what", ["key", "token", "encoding"])
def test_messages_that_zenoh_cannot_carry_break_only_their_sender(
    room: AttackedClass, what: str
) -> None:
    program = json.dumps([dialling(room.port, room.ben.credentials), what])
    with contextlib.suppress(subprocess.TimeoutExpired):
        subprocess.run(
            [sys.executable, "-c", BREAKING],
            input=program.encode(),
            timeout=5,
            check=False,
            capture_output=True,
        )


def test_flood_the_admission_service(room: AttackedClass, lobby_user: zenoh.Session) -> None:
    hello = json.dumps({"op": "enrol", **PinClient(Secret("0")).hello()})
    waiting = [
        lobby_user.get(ADMISSION_KEY, zenoh.handlers.FifoChannel(1), payload=hello, timeout=20)
        for _ in range(600)
    ]
    room.check_honest_work()
    del waiting


# -- the admin space, secrets, names -----------------------------------------------------------


def test_read_and_write_the_admin_space(room: AttackedClass, ben: zenoh.Session) -> None:
    hub = next(iter(room.teacher_session.info.routers_zid()))
    for key in (f"@/{hub}/router/**", "@/**", f"@/{hub}/router/config/**"):
        found = [str(reply.ok.key_expr) for reply in ben.get(key, timeout=2) if reply.ok]
        assert not [one for one in found if one.startswith(f"@/{hub}")]
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
    logs = b"".join((one.folder / "zbot" / "hub.log").read_bytes() for one in everybody)
    assert not [one for one in [*secrets, PIN.encode()] if one in lines + logs]


@pytest.mark.skipif(os.name == "nt", reason="Windows has no file modes")
def test_secret_files_are_readable_by_their_owner_only(room: AttackedClass) -> None:
    for computer in (room.teacher, room.ana):
        folder = computer.folder / "zbot"
        assert stat.S_IMODE(folder.stat().st_mode) == 0o700
        found = [folder / name for name in SECRET_FILES if (folder / name).exists()]
        assert len(found) >= 4
        assert {stat.S_IMODE(path.stat().st_mode) for path in found} == {0o600}


NAMES = [
    "\x1b[2J\x1b]0;owned\x07Eve",
    "$(touch owned); `touch owned` | touch owned",
    "../../../owned",
    "<script>alert(1)</script>",
    "Eve\r\nAna",
    "\u202eevE\u2066",
    "x" * 10_000,
    "{0.__class__} %s %n",
    "'; DROP TABLE students; --",
]


def test_names_are_never_interpreted(room: AttackedClass, lobby_user: zenoh.Session) -> None:
    for number, name in enumerate(NAMES, 50):
        request = {"machine": f"eve{number}", "host": name, "name": name, "number": number}
        assert "refused" not in claimed(lobby_user, PIN, request)["answer"]
    shown = room.teacher.do("class", "list")
    assert is_plain(shown)
    assert all(len(line) < 300 for line in shown.splitlines())
    listed = room.listed()
    assert all(0 < len(listed[number]["name"]) <= 64 for number, _ in enumerate(NAMES, 50))
    assert not list(room.teacher.folder.parent.rglob("owned*"))


@pytest.mark.parametrize(
    "name", [NAMES[0], NAMES[1], "x" * 10_000], ids=["escape", "shell", "long"]
)
def test_a_joining_laptop_prints_a_name_as_plain_text(
    room: AttackedClass, eve: Computer, name: str
) -> None:
    where = (f"{HERE}:{room.port}", "--number", "60", f"--name={name}")
    joined = eve.do("join", *where, ZBOT_PIN=PIN)
    eve.do("leave")
    assert is_plain(joined)
    assert all(len(line) < 300 for line in joined.splitlines())
    assert not list(eve.folder.parent.rglob("owned*"))


def test_a_notice_is_printed_as_plain_text(room: AttackedClass) -> None:
    room.teacher.do("class", "say", "\x1b[2J$(reboot)\r\n<script>")
    notices = [
        json.loads(reply.ok.payload.to_bytes())
        for reply in room.honest.get(NOTICES_KEY, timeout=2)
        if reply.ok
    ]
    assert notices
    assert answers(room.honest, NOTICES_KEY)
