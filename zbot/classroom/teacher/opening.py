"""Teacher's side of a class: functions to open it, to send it commands, and to close it."""

from __future__ import annotations

import contextlib
import secrets
import time
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from zbot.classroom.errors import (
    ClassCommandError,
    already_joined_error,
    no_class_error,
    open_class_error,
    other_class_error,
)
from zbot.classroom.hub import running_hub
from zbot.classroom.hub.address import own_addresses
from zbot.classroom.hub.link import Link
from zbot.classroom.hub.process import serve
from zbot.classroom.hub.queries import ask
from zbot.classroom.keys import COMMAND_KEY
from zbot.classroom.teacher.class_check import check, snapshots
from zbot.classroom.teacher.class_record import ClassRecord, load_record, record_path
from zbot.classroom.teacher.running_class import RunningClass
from zbot.classroom.teacher.student_list import StudentList
from zbot.security.access import TEACHER
from zbot.security.pin import random_pin
from zbot.threads.deadline import Deadline, poll
from zbot.transport import membership
from zbot.transport.config import hub_port
from zbot.transport.meeting_port import LOOPBACK
from zbot.transport.membership import Membership
from zbot.transport.session import open_hub_client

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from pathlib import Path

    import zenoh

    from zbot.classroom.teacher.class_check import Verdict
    from zbot.classroom.teacher.expectation import Expectation
    from zbot.graph.snapshot import Snapshot

#: Name of a class if the teacher gives no name.
DEFAULT_NAME = "class"

_MASTER_BYTES = 32
_REOPENING_S = 3.0  # a hub usually reopens in 0.2 s
_PAUSE_S = 0.05
_ANSWER_TIMEOUT_S = 5.0


@dataclass(frozen=True)
class ClassOptions:
    """Options for a class.

    `None` and `False` keep the option of a class that exists. For a new class, they mean the
    default.
    """

    name: str | None = None  #: by default, the name of the class that continues, or `class`
    port: int | None = None  #: TCP port of the hub; by default the port of this machine's own hub
    with_pin: bool = False  #: whether students must know a PIN
    pin: str = ""  #: the PIN that the teacher has chosen; by default a random PIN
    new_pin: bool = False  #: whether the class gets another PIN
    expected: dict[int, str] | None = None  #: names of students by number
    keystore: Path | None = None  #: folder of this machine's certificate; by default plain TCP
    sensors: bool | None = None  #: whether pages may publish the sensors of browsers


def start(options: ClassOptions) -> tuple[Membership, ClassRecord]:
    """Open a class: start its hub in the background, so that students can join.

    If a class was open when this machine was switched off, that class continues. Its laptops
    reconnect by themselves and keep their numbers, and its PIN stays the same. If the class is open
    now, it stays open. It gets a new PIN if `new_pin` is true.

    Returns:
        The teacher's membership and the record of the class.

    Raises:
        ClassroomError: This machine has joined a class or hub, or runs a hub, or another class is
            open, or was open when this machine was switched off, or the class has other options, or
            another program uses the port.
        SecurityError: This machine's certificate is not suitable for a class.
    """
    present, runs = membership.load(), running_hub.find() is not None
    if present is None or present.role != "teacher":
        _check_free(present, runs=runs)
        name = options.name or DEFAULT_NAME
        students = StudentList(secrets.token_hex(_MASTER_BYTES))
        return _open(name, ClassRecord(name, students), options)
    if options.name not in {None, present.class_name}:
        raise other_class_error(present.class_name)
    record = load_record()
    _check_options(present, record, options, runs=runs)
    if runs and options.sensors is not None:
        command({"op": "sensors", "on": options.sensors})
        record = load_record()
    if runs and not options.new_pin:
        return present, record
    running_hub.stop()
    # A hub that runs writes the record, so the record is read again after the hub has ended.
    return _open(present.class_name, load_record(), options, present)


def _check_free(present: Membership | None, *, runs: bool) -> None:
    if present is not None:
        raise already_joined_error(f"has joined {present.class_name or present.host}")
    if runs:
        raise already_joined_error("runs a hub")


def _check_options(
    present: Membership, record: ClassRecord, options: ClassOptions, *, runs: bool
) -> None:
    """Raise `ClassroomError` if the options do not fit the class that exists."""
    if (options.with_pin or options.new_pin) and not record.pin:
        raise open_class_error(present.class_name, "has no PIN")
    if options.pin and options.pin != record.pin and not options.new_pin:
        raise open_class_error(present.class_name, "has another PIN (`--new-pin` changes it)")
    if not runs:
        return
    keystore = Link.named(options.keystore).keystore
    wanted = {
        "port": (options.port, present.port),
        "list of students": (options.expected, record.students.expected),
        "keystore": (keystore, record.keystore),
    }
    for what, (given, known) in wanted.items():
        if given and given != known:
            raise open_class_error(present.class_name, f"has another {what}")


def _open(
    name: str, record: ClassRecord, options: ClassOptions, present: Membership | None = None
) -> tuple[Membership, ClassRecord]:
    if options.new_pin or (options.with_pin and not record.pin):
        record.pin = options.pin or random_pin().reveal()
    record.students.expected = options.expected or record.students.expected
    if options.sensors is not None:
        record.has_sensors = options.sensors
    host = next(iter(own_addresses()), LOOPBACK)
    record.keystore = Link.named(options.keystore).keystore or record.keystore
    Link(record.keystore).check_listening(host)
    port = options.port or (present.port if present is not None else hub_port())
    opened = Membership("teacher", host, port, class_name=name, hub_port=hub_port())
    if record.pin:
        opened = replace(opened, user=TEACHER, secret=record.students.secret_of(TEACHER))
    record.save()
    membership.save(opened)
    try:
        running_hub.start("teacher")
    except BaseException:
        if present is None:
            _forget()
        raise
    running_hub.end_router()
    return opened, record


def stop() -> Membership:
    """Close the class that is open on this machine, and return the teacher's membership.

    Raises:
        ClassroomError: No class is open.
    """
    present = membership.load()
    if present is None or present.role != "teacher":
        raise no_class_error()
    # If the hub does not answer, the class is closed without a notice to the students.
    with contextlib.suppress(ClassCommandError):
        command({"op": "close"})
    running_hub.stop()
    _forget()
    running_hub.end_router()
    return present


def _forget() -> None:
    membership.forget()
    record_path().unlink(missing_ok=True)


def _client() -> zenoh.Session:
    """Open a client session at the class's hub."""
    present = membership.load()
    if present is None or present.role != "teacher":
        raise no_class_error()
    # The hub is closed for a moment when its rules change, e.g. after the previous command.
    deadline = Deadline(_REOPENING_S)
    while (session := open_hub_client()) is None:
        if deadline.is_over or running_hub.find() is None:
            raise ClassCommandError("the class does not run: continue it with `zbot class start`")
        time.sleep(_PAUSE_S)
    return session


def _ask(question: dict[str, Any]) -> list[dict[str, Any]]:
    def answers() -> list[dict[str, Any]]:
        with _client() as session:
            return ask(session, COMMAND_KEY, question, timeout_s=_ANSWER_TIMEOUT_S)

    # A hub that is about to reopen may accept a client and then close without a reply.
    return poll(answers, _REOPENING_S, _PAUSE_S)


def command(question: dict[str, Any]) -> dict[str, Any]:
    """Send a command to the class that is open on this machine, and return the reply.

    Raises:
        ClassroomError: No class is open.
        ClassCommandError: The class does not answer, or refuses the command. The message says why.
    """
    answers = _ask(question)
    if not answers or "error" in answers[0]:
        told = answers[0]["error"] if answers else "the class does not answer: try again"
        raise ClassCommandError(str(told))
    return answers[0]


def check_class(expectations: Sequence[Expectation]) -> list[Verdict]:
    """Return a verdict for each student who has joined.

    Raises:
        ClassroomError: No class is open on this machine.
        ClassCommandError: The class does not run.
    """
    students = command({"op": "list"})["students"]
    with _client() as session:
        return check(session, students, expectations)


def graph_of(number: int) -> Snapshot:
    """Return the graph of a student's domain.

    Raises:
        ClassroomError: No class is open on this machine.
        ClassCommandError: The class does not run.
    """
    with _client() as session:
        return snapshots(session, [number])[number]


def run_teacher(opened: Membership, on_ready: Callable[[], None]) -> None:
    """Run the hub of a class until SIGTERM or SIGINT."""
    running = RunningClass(load_record(), opened.port)
    serve("teacher", running.settings, on_ready, running.attach)
