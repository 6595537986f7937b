"""Attacks with malformed or misleading data."""

from __future__ import annotations

import contextlib
import json
import subprocess
import sys
import threading
import time

import pytest
import zenoh

from tests.classroom.attacked import PIN, AttackedClass, Computer
from tests.classroom.attacks.conftest import claimed, is_plain
from tests.classroom.talk import HERE, answers, dialling
from tests.conftest import allowed, wait_until
from zbot.classroom.keys import MAX_LISTED_NODES, NOTICES_KEY, facts_key, here_key
from zbot.security.access import MAX_MESSAGE_SIZE


@pytest.fixture(scope="module")
def eve(opened: AttackedClass) -> Computer:
    return opened.computer("eve")


def test_oversize_samples(room: AttackedClass, ben: zenoh.Session) -> None:
    subscriber = room.teacher_session.declare_subscriber("18/big", zenoh.handlers.FifoChannel(10))
    room.talk.settle()
    ben.put("18/big", b"x" * (MAX_MESSAGE_SIZE + 1))
    ben.put(facts_key(18), b"x" * (MAX_MESSAGE_SIZE + 1))
    room.check_honest_work()
    assert subscriber.try_recv() is None
    subscriber.undeclare()


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
    for alive in declared:
        alive.undeclare()


def test_a_flood_of_tokens_does_not_fill_the_teachers_list(
    room: AttackedClass, ben: zenoh.Session
) -> None:
    space = "@zbot/18/a"
    declared = [
        ben.liveliness().declare_token(f"{space}/{number}/{number}/NN/%/%/node_{number}")
        for number in range(2000)
    ]
    assert wait_until(lambda: len(room.listed()[18]["nodes"]) == MAX_LISTED_NODES, 20)
    began_s = time.monotonic()
    shown = room.teacher.do("class", "list")
    assert time.monotonic() - began_s < allowed(2)
    row = next(line for line in shown.splitlines() if "Ben" in line)
    assert f"more than {MAX_LISTED_NODES} nodes, the rest is not shown" in row
    assert "Ana" in shown
    for token in declared:
        token.undeclare()
    assert wait_until(lambda: room.listed()[18]["nodes"] == [], 20)


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
