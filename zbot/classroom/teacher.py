"""Teacher's side of a class: functions to open it, to send it commands, and to close it."""

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
from zbot.classroom.keys import COMMAND_KEY
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
_REOPENING_S = 3.0  # a hub usually reopens in 0.2 s
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
    """Open a class: start its hub in the background, so that students can join.

    If a class with the same name was open when this machine was switched off, that class continues.
    Its laptops reconnect by themselves and keep their numbers.

    Args:
        name: The class's name, shown to students.
        port: TCP port of the hub.
        pin: PIN that students must know. If empty, a class that continues keeps its PIN, and a new
            class has no PIN.
        expected: Names of students by number.
        keystore: Folder of this machine's certificate. If it is `None`, a class that continues
            keeps its keystore, and a new class uses plain TCP.

    Returns:
        The teacher's membership and the record of the class.

    Raises:
        AlreadyJoinedError: This machine has joined a class or hub, or runs a hub.
        HubStartError: Another program uses the port.
        SecurityError: This machine's certificate is not suitable for a class.
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
    """Close the class that is open on this machine, and return the teacher's membership.

    Raises:
        NoClassError: No class is open.
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
    """Open a client session at the class's hub."""
    present = membership.load()
    if present is None or present.role != "teacher":
        raise NoClassError
    # The hub is closed for a moment when its rules change, e.g. after the previous command.
    deadline = time.monotonic() + _REOPENING_S
    while (session := open_hub_client()) is None:
        if time.monotonic() > deadline or background.find() is None:
            raise ClassCommandError("the class does not run: continue it with `zbot class start`")
        time.sleep(_PAUSE_S)
    return session


def _ask(question: dict[str, Any]) -> list[dict[str, Any]]:
    # A hub that is about to reopen may accept a client and then close without a reply.
    deadline = time.monotonic() + _REOPENING_S
    while True:
        with _client() as session:
            answers = ask(session, COMMAND_KEY, question, timeout_s=_ANSWER_TIMEOUT_S)
        if answers or time.monotonic() > deadline:
            return answers
        time.sleep(_PAUSE_S)


def command(question: dict[str, Any]) -> dict[str, Any]:
    """Send a command to the class that is open on this machine, and return the reply.

    Raises:
        NoClassError: No class is open.
        ClassCommandError: The class does not answer, or refuses the command. The message says
            why.
    """
    answers = _ask(question)
    if not answers or "error" in answers[0]:
        told = answers[0]["error"] if answers else "the class does not answer: try again"
        raise ClassCommandError(str(told))
    return answers[0]


def check_class(expectations: Sequence[Expectation]) -> list[Verdict]:
    """Return a verdict for each student who has joined.

    Raises:
        NoClassError: No class is open on this machine.
        ClassCommandError: The class does not run.
    """
    students = command({"op": "list"})["students"]
    with _client() as session:
        return check(session, students, expectations)


def graph_of(number: int) -> Snapshot:
    """Return the graph of a student's domain.

    Raises:
        NoClassError: No class is open on this machine.
        ClassCommandError: The class does not run.
    """
    with _client() as session:
        return snapshots(session, [number])[number]


def run_teacher(opened: Membership, on_ready: Callable[[], None]) -> None:
    """Run the hub of a class until SIGTERM or SIGINT."""
    classroom = Classroom(load_record(), opened.port)
    serve("teacher", classroom.settings, on_ready, classroom.attach)


def address_of(opened: Membership) -> Address:
    """Return the address at which students join a class."""
    return Address(opened.host, opened.port)
