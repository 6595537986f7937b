"""The teacher's side: opening a class, asking it something, and closing it."""

from __future__ import annotations

import secrets
import time
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from zbot.classroom import background
from zbot.classroom.address import Address, own_addresses
from zbot.classroom.class_check import check, snapshots
from zbot.classroom.class_record import ClassRecord, load_record, record_path
from zbot.classroom.classroom import Classroom
from zbot.classroom.errors import AlreadyJoinedError, ClassCommandError, NoClassError
from zbot.classroom.hub_process import serve
from zbot.classroom.hub_queries import ask
from zbot.classroom.keys import DESK_KEY
from zbot.classroom.link import Link
from zbot.security.access import TEACHER
from zbot.transport import membership
from zbot.transport.membership import Membership
from zbot.transport.session import LOOPBACK, open_hub_client

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from pathlib import Path

    import zenoh

    from zbot.classroom.class_check import Verdict
    from zbot.classroom.expectation import Expectation
    from zbot.graph.snapshot import Snapshot

_MASTER_BYTES = 32
_REOPENING_S = 3.0  # 0.2 s are usual
_PAUSE_S = 0.05
_ANSWER_TIMEOUT_S = 5.0


def start(
    name: str,
    port: int,
    *,
    pin: str = "",
    expected: dict[int, str] | None = None,
    keystore: Path | None = None,
) -> tuple[Membership, ClassRecord]:
    """Open a class: leave a hub running that students can join.

    One that was open under the same name, before this machine was switched off, goes on: its
    students come back by themselves, with their numbers.

    Args:
        name: Shown to students.
        port: TCP port to be reached at.
        pin: Asked of students; empty for none, and for that of a class that goes on.
        expected: Names of students, by number.
        keystore: Folder of this machine's certificate, for a class whose hubs use them; left out
            for none, and for that of a class that goes on.

    Raises:
        AlreadyJoinedError: This machine takes part in something.
        HubStartError: The port is taken.
        SecurityError: With this certificate nobody could join.
    """
    record = _present_record(name)
    record.pin = pin or record.pin
    record.register.expected = expected or record.register.expected
    host = next(iter(own_addresses()), LOOPBACK)
    record.keystore = Link.named(keystore).keystore or record.keystore
    Link(record.keystore).check_listening(host)
    opened = Membership("teacher", host, port, class_name=name)
    if record.pin:
        opened = replace(opened, user=TEACHER, secret=record.secret_of(TEACHER))
    record.save()
    membership.save(opened, record.users())
    try:
        background.start("teacher")
    except BaseException:
        _forget()
        raise
    return opened, record


def _present_record(name: str) -> ClassRecord:
    present, runs = membership.load(), background.find() is not None
    if present is not None and (runs or present.role != "teacher"):
        raise AlreadyJoinedError(f"has joined {present.class_name or present.host}")
    if runs:
        raise AlreadyJoinedError("runs a hub")
    if present is not None and present.class_name == name:
        return load_record()
    return ClassRecord(name, secrets.token_hex(_MASTER_BYTES))


def stop() -> Membership:
    """Close the class that is open on this machine; the students' laptops stay joined to nothing.

    Raises:
        NoClassError: There is none.
    """
    present = membership.load()
    if present is None or present.role != "teacher":
        raise NoClassError
    background.stop()
    _forget()
    return present


def _forget() -> None:
    membership.forget()
    record_path().unlink(missing_ok=True)


def _client() -> zenoh.Session:
    """Open a session at the class's hub."""
    present = membership.load()
    if present is None or present.role != "teacher":
        raise NoClassError
    # The hub is closed for a moment whenever somebody is let in or out: by the command before this
    # one, perhaps.
    deadline = time.monotonic() + _REOPENING_S
    while (session := open_hub_client()) is None:
        if time.monotonic() > deadline or background.find() is None:
            raise ClassCommandError("the class does not run: `zbot class start` lets it go on")
        time.sleep(_PAUSE_S)
    return session


def _ask(question: dict[str, Any]) -> list[dict[str, Any]]:
    # A hub that is about to be opened anew may still let somebody in, and answers no more.
    deadline = time.monotonic() + _REOPENING_S
    while True:
        with _client() as session:
            answers = ask(session, DESK_KEY, question, timeout_s=_ANSWER_TIMEOUT_S)
        if answers or time.monotonic() > deadline:
            return answers
        time.sleep(_PAUSE_S)


def command(question: dict[str, Any]) -> dict[str, Any]:
    """Ask the class that is open on this machine.

    Raises:
        NoClassError: There is none.
        ClassCommandError: It refuses; its sentence says why.
    """
    answers = _ask(question)
    if not answers or "error" in answers[0]:
        told = answers[0]["error"] if answers else "the class does not answer: try again"
        raise ClassCommandError(str(told))
    return answers[0]


def check_class(expectations: Sequence[Expectation]) -> list[Verdict]:
    """Return whether everybody who has joined does what is expected.

    Raises:
        NoClassError: There is no class on this machine.
        ClassCommandError: It does not run.
    """
    students = command({"op": "list"})["students"]
    with _client() as session:
        return check(session, students, expectations)


def graph_of(number: int) -> Snapshot:
    """Return the graph of a student's domain.

    Raises:
        NoClassError: There is no class on this machine.
        ClassCommandError: It does not run.
    """
    with _client() as session:
        return snapshots(session, [number])[number]


def run_teacher(opened: Membership, on_ready: Callable[[], None]) -> None:
    """Be the hub of a class until a signal comes."""
    classroom = Classroom(load_record(), opened.port)
    serve("teacher", classroom.settings, on_ready, classroom.equip)


def address_of(opened: Membership) -> Address:
    """Return where students find a class."""
    return Address(opened.host, opened.port)
