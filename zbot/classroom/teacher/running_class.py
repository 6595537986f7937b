"""Class of students, run by the teacher's hub process: admission and the teacher's commands."""

from __future__ import annotations

import contextlib
import json
import threading
import time
from typing import TYPE_CHECKING, Any

import zenoh

from zbot.classroom.errors import ClassroomError, ReopeningError
from zbot.classroom.hub.address import EVERYWHERE, Address
from zbot.classroom.hub.identity import certificate_identity, own_identities
from zbot.classroom.hub.link import Link
from zbot.classroom.hub.router import HubSettings
from zbot.classroom.join_request import is_proof
from zbot.classroom.keys import ADMISSION_KEY, COMMAND_KEY, NOTICES_KEY
from zbot.classroom.teacher.accepted_identities import NUMBERS, AcceptedIdentities
from zbot.classroom.teacher.class_record import MAX_NOTICES, ClassRecord, user_of
from zbot.classroom.teacher.join_service import AdmissionService
from zbot.classroom.teacher.laptops import Attendance
from zbot.classroom.teacher.robots import Robots
from zbot.classroom.teacher.student_list import NumberError
from zbot.log.teacher_notice import NOTICE_KEY
from zbot.security.access import Share, teacher_access
from zbot.threads.foreign_call import called_by_zenoh
from zbot.transport import membership
from zbot.transport.config import MAX_DOMAIN_ID

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.classroom.hub.process import HubProcess
    from zbot.classroom.teacher.student_list import Student

Document = dict[str, Any]

_AGAIN = "type `zbot leave`, and join again if you take part"
# A laptop that joins needs less than 20 s until its hub is linked (see `student`). After this time,
# the class frees the number of a laptop that never was.
_JOINING_S = 60.0
# A laptop ends its hub before it releases its number. If the hub of a former owner is still linked
# after this time, it does not end by itself.
_LEAVING_S = 2.0


class Classroom:
    """An open class of students.

    Args:
        record: The class's data, which are stored in a file.
        port: TCP port of the hub.
    """

    def __init__(self, record: ClassRecord, port: int) -> None:
        self._record = record
        self._port = port
        self._attendance = Attendance()
        self._robots = Robots()
        self._lock = threading.RLock()  # each of the three queryables has a thread
        self._serving: HubProcess | None = None
        self._accepted = AcceptedIdentities(record)
        self._joining: dict[int, tuple[str, float]] = {}  # claims, and when they were made
        self._fingerprint = ""
        self._admission = AdmissionService(
            record.name,
            record.pin,
            record.register,
            is_own_hub=self._is_own_hub,
            credentials=self._credentials,
            changed=self._on_claim,
            is_here=lambda number: self._attendance.laptop(number).is_here,
        )

    def settings(self) -> HubSettings:
        """Return the endpoints and access rules of a hub that is opened now. Write its users."""
        link = Link(self._record.keystore)
        listen = link.listening(Address(EVERYWHERE, self._port))
        with self._lock:
            self._accepted = AcceptedIdentities(self._record)
            if self._record.pin:
                membership.save_users(self._accepted.users())
            settings = teacher_access(
                {user_of(number): number for number in NUMBERS},
                shared_is_open=self._record.is_open,
                shares=[Share(owner, user_of(reader)) for owner, reader in self._record.shares],
                drivers={user_of(number): name for name, number in self._robots.drivers.items()},
            )
            self._accepted.apply(settings["access_control"])
        return HubSettings(listen, extra=settings | link.settings)

    def attach(self, serving: HubProcess) -> None:
        """Begin to answer laptops and the teacher through a hub that was opened."""
        self._serving = serving
        self._fingerprint = Link(self._record.keystore).fingerprint()
        serving.answer_queries(ADMISSION_KEY, self._answer_admission)
        serving.answer_queries(COMMAND_KEY, self._answer_command)
        serving.answer_queries(NOTICES_KEY, self._answer_student)
        self._attendance.attach(serving, self._record.register.students)
        self._transports = serving.session.info.declare_transport_events_listener(
            called_by_zenoh(self._on_transport), history=True
        )

    def _on_transport(self, event: Any) -> None:
        """Reopen the hub if a former owner of a number has connected."""
        if event.kind == zenoh.SampleKind.PUT:
            self._reject_former({str(event.transport.zid)})

    def _reject_former(self, connected: set[str]) -> None:
        if self._serving is not None and connected & self._accepted.former_hub_ids():
            self._serving.reopen()

    def _reject_former_links(self) -> None:
        """Reopen the hub if a former owner of a number is still connected."""
        assert self._serving is not None
        with contextlib.suppress(zenoh.ZError):  # the hub is being reopened
            self._reject_former({str(one.zid) for one in self._serving.session.info.transports()})

    def _answer_admission(self, question: Document) -> Document:
        with self._lock:
            self._free_failed_joins()
            return self._admission.answer(question)

    def _free_failed_joins(self) -> None:
        """Free the numbers of laptops that were admitted, but were never linked with the class."""
        late_s = time.monotonic() - _JOINING_S
        for number, (claim, since_s) in list(self._joining.items()):
            if since_s > late_s:
                continue
            del self._joining[number]
            student = self._record.register.students.get(number)
            is_same = student is not None and student.claim == claim
            if is_same and not self._attendance.laptop(number).is_here:
                self._record.register.free(number)
                self._on_claim(number)

    def _answer_student(self, question: Document) -> Document:
        """Return the notices. The owner of a number also gets the names of its nodes."""
        found: Document = {"notices": self._record.notices}
        student = self._record.register.students.get(_number_or_0(question))
        if student is not None and is_proof(question.get("proof"), student.claim, "nodes"):
            self._joining.pop(student.number, None)
            found["nodes"] = self._attendance.nodes.listed(student.number)[0]
            found["here"] = self._attendance.laptop(student.number).is_here
            found["namesakes"] = self._record.register.namesakes(student)
        return found

    def _is_own_hub(self, dialled: str) -> bool:
        """Return whether a laptop is connected to this hub itself.

        Return false if the laptop is connected to a program that forwards to this hub. In a class
        without a PIN, return true, because such a program can join by itself.
        """
        assert self._serving is not None
        if not self._record.pin:
            return True
        if self._fingerprint and dialled == certificate_identity(self._fingerprint):
            return True
        return dialled in own_identities(self._serving.session)

    def _on_claim(self, number: int) -> None:
        student = self._record.register.students.get(number)
        if student is None:
            self._forget(number)
        else:
            self._joining[number] = (student.claim, time.monotonic())
            if self._record.assign(number, student.machine):
                self._later(self._reject_former_links)
            self._attendance.watch(number)
        self._record.save()

    def _forget(self, number: int) -> None:
        self._joining.pop(number, None)
        self._attendance.forget(number)

    @staticmethod
    def _later(work: Callable[[], None]) -> None:
        timer = threading.Timer(_LEAVING_S, work)
        timer.daemon = True
        timer.start()

    def _credentials(self, number: int) -> dict[str, str]:
        """Return the credentials of a number's owner.

        Raises:
            ReopeningError: The hub accepts them only after it was reopened. It is reopened now.
        """
        if not self._accepted.accepts(number):
            self._apply()
            raise ReopeningError
        return self._record.credentials(number)

    def _answer_command(self, question: Document) -> Document:
        verbs = {
            "list": self._list,
            "say": self._say,
            "free": self._free,
            "next": self._next,
            "share": self._share,
            "open": self._open,
            "close": self._close,
            "robot": self._robot,
            "give": self._give,
        }
        verb = verbs.get(str(question.get("op")))
        if verb is None:
            return {"error": "the class does not know this command: the class's zbot may be older"}
        # Commands that change something run one at a time. `list` waits for slow laptops, so it
        # does not take the lock.
        try:
            with contextlib.nullcontext() if verb == self._list else self._lock:
                return verb(question)
        except ClassroomError as error:
            return {"error": str(error)}

    def _list(self, _question: Document) -> Document:
        with self._lock:
            self._free_failed_joins()
        self._attendance.refresh()
        students = sorted(self._record.register.students.values(), key=lambda one: one.number)
        missing = self._record.register.expected.keys() - self._record.register.students.keys()
        return {
            "class": self._record.name,
            "students": [self._row(one) for one in students],
            "expected": [
                {"number": number, "name": self._record.register.expected[number]}
                for number in sorted(missing)
            ],
            "students_can_publish": self._record.is_open,
            "shares": [list(share) for share in self._record.shares],
            "robots": [
                {"name": name, "driver": self._robots.drivers.get(name)}
                for name in self._robots.connected()
            ],
        }

    def _row(self, student: Student) -> Document:
        nodes, more_nodes = self._attendance.nodes.listed(student.number)
        laptop = self._attendance.laptop(student.number)
        return {
            "number": student.number,
            "name": student.name,
            "host": student.host,
            "here": laptop.is_here,
            "since": laptop.since_ns / 1e9 or None,
            "nodes": nodes,
            "more_nodes": more_nodes,
            "last_error": laptop.last_error,
            "clock_offset": laptop.clock_offset_s if laptop.is_here else None,
            "version": laptop.version,
            "system": laptop.system,
        }

    def _say(self, question: Document) -> Document:
        assert self._serving is not None
        notice = {"text": str(question.get("text", "")), "time": time.time()}
        self._record.notices = [*self._record.notices, notice][-MAX_NOTICES:]
        self._record.save()
        self._serving.session.put(NOTICE_KEY, json.dumps(notice))
        return {"heard": len(self._attendance.present())}

    def _close(self, _question: Document) -> Document:
        """Tell all students that the class is closed. The teacher's command then ends the hub."""
        assert self._serving is not None
        self._notify(f'the class "{self._record.name}" is closed', closed=True)
        return {"heard": len(self._attendance.present())}

    def _notify(self, text: str, **more: bool) -> None:
        """Send a notice, and wait until the laptops have received it."""
        assert self._serving is not None
        notice = {"text": text, "time": time.time(), **more}
        self._serving.session.put(NOTICE_KEY, json.dumps(notice))
        self._attendance.refresh()  # the laptops answer after they have received the notice

    def _free(self, question: Document) -> Document:
        number = _number(question.get("number"))
        student = self._record.register.free(number)
        if student is None:
            return {"error": f"no student has number {number}"}
        is_here = self._attendance.laptop(number).is_here
        self._record.renew(number)
        self._forget(number)
        self._apply()
        return {"freed": number, "name": student.name, "host": student.host, "here": is_here}

    def _next(self, question: Document) -> Document:
        """Begin a new period: free all numbers. The name, the code and the PIN stay the same."""
        assert self._serving is not None
        students = list(self._record.register.students)
        self._notify(f'a new period of the class "{self._record.name}" has begun: {_AGAIN}')
        given = question.get("expected")
        expected = self._record.register.expected if given is None else _expected(given)
        for robot in self._robots.drivers:
            self._robots.give(robot, None)
        self._robots.publish(self._serving.session)
        self._record.begin_period(expected)
        for number in students:
            self._forget(number)
        self._apply()
        return {"class": self._record.name, "freed": len(students)}

    def _robot(self, question: Document) -> Document:
        """Note that a robot's bridge runs, and return the number of the student who drives."""
        return {"driver": self._robots.note(str(question.get("robot")))}

    def _give(self, question: Document) -> Document:
        """Let one student drive a robot. Without a number, nobody drives."""
        assert self._serving is not None
        robot, given = str(question.get("robot")), question.get("number")
        number = None if given is None else _number(given)
        student = None if number is None else self._record.register.students.get(number)
        if number is not None and student is None:
            return {"error": f"no student has number {number}"}
        before = self._robots.drivers
        self._robots.give(robot, number)
        # This happens before `_apply` reopens the hub, so that the robot stops immediately.
        self._robots.publish(self._serving.session)
        if self._robots.drivers != before:
            self._apply()
        return {"robot": robot, "number": number, "name": student.name if student else ""}

    def _share(self, question: Document) -> Document:
        share = (_number(question.get("owner")), _number(question.get("reader")))
        others = [one for one in self._record.shares if one != share]
        self._record.shares = [*others, share] if question.get("on", True) else others
        self._apply()
        return {"shares": [list(one) for one in self._record.shares]}

    def _open(self, question: Document) -> Document:
        self._record.is_open = bool(question.get("on", True))
        self._apply()
        return {"open": self._record.is_open}

    def _apply(self) -> None:
        """Save the data and reopen the hub, because Zenoh reads rules when a session opens."""
        assert self._serving is not None
        self._record.save()
        self._serving.reopen()


def _number_or_0(question: Document) -> int:
    number = question.get("number")
    return number if isinstance(number, int) else 0


def _number(value: object) -> int:
    if not isinstance(value, int) or not 1 <= value <= MAX_DOMAIN_ID:
        raise NumberError(value)
    return value


def _expected(given: object) -> dict[int, str]:
    """Return the names by number in a command. Names come from the teacher's own file."""
    document = given if isinstance(given, dict) else {}
    return {int(number): str(name) for number, name in document.items()}
