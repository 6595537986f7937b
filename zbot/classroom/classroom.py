"""Class of students, run by the teacher's hub process: admission and the teacher's commands."""

from __future__ import annotations

import contextlib
import json
import threading
import time
from typing import TYPE_CHECKING, Any

from zbot.classroom.address import EVERYWHERE, Address
from zbot.classroom.admission import AdmissionService, is_proof
from zbot.classroom.attendance import Attendance
from zbot.classroom.class_record import MAX_NOTICES, ClassRecord, user_of
from zbot.classroom.errors import ClassroomError
from zbot.classroom.hub import HubSettings
from zbot.classroom.hub_identity import certificate_identity, own_identities
from zbot.classroom.keys import ADMISSION_KEY, COMMAND_KEY, NOTICES_KEY
from zbot.classroom.link import Link
from zbot.classroom.register import NumberError
from zbot.classroom.robots import Robots
from zbot.log.teacher_notice import NOTICE_KEY
from zbot.security.access import TEACHER, Share, teacher_access
from zbot.transport import membership
from zbot.transport.config import MAX_DOMAIN_ID

if TYPE_CHECKING:
    from zbot.classroom.hub_process import HubProcess
    from zbot.classroom.register import Student

Document = dict[str, Any]

_NUMBERS = range(1, MAX_DOMAIN_ID + 1)
# The names of the loopback interface on Linux, macOS and Windows.
_LOOPBACK_INTERFACES = ("lo", "lo0", "Loopback Pseudo-Interface 1")


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
        self._fingerprint = ""
        self._admission = AdmissionService(
            record.name,
            record.pin,
            record.register,
            is_own_hub=self._is_own_hub,
            credentials=record.credentials,
            changed=self._on_claim,
            is_here=lambda number: self._attendance.laptop(number).is_here,
        )

    def settings(self) -> HubSettings:
        """Return the hub's endpoints and access rules."""
        link = Link(self._record.keystore)
        listen = link.listening(Address(EVERYWHERE, self._port))
        students = {user_of(number): number for number in _NUMBERS}
        shares = [Share(owner, user_of(reader)) for owner, reader in self._record.shares]
        settings = teacher_access(
            students,
            shared_is_open=self._record.is_open,
            shares=shares,
            drivers={user_of(number): robot for robot, number in self._robots.drivers.items()},
        )
        if not self._record.pin:
            self._use_hub_ids(settings["access_control"])
        settings |= link.settings
        return HubSettings(listen, extra=settings)

    def _use_hub_ids(self, access: Document) -> None:
        """Apply a student's rules to the Zenoh id of that student's hub, not to a user name."""
        ids = {user_of(number): self._record.hub_id(number) for number in _NUMBERS}
        for subject in access["subjects"]:
            user = subject["id"]
            del subject["usernames"]
            if user in ids:
                subject["zids"] = [ids[user]]
            elif user == TEACHER:
                subject["interfaces"] = list(_LOOPBACK_INTERFACES)
            # The subject of the user `lobby` has no condition now, so its rules apply to everybody.

    def attach(self, serving: HubProcess) -> None:
        """Begin to answer laptops and the teacher through a hub that was opened."""
        self._serving = serving
        self._fingerprint = Link(self._record.keystore).fingerprint()
        serving.answer_queries(ADMISSION_KEY, self._answer_admission)
        serving.answer_queries(COMMAND_KEY, self._answer_command)
        serving.answer_queries(NOTICES_KEY, self._answer_student)
        self._attendance.attach(serving, self._record.register.students)

    def _answer_admission(self, question: Document) -> Document:
        with self._lock:
            return self._admission.answer(question)

    def _answer_student(self, question: Document) -> Document:
        """Return the notices. The owner of a number also gets the names of its nodes."""
        found: Document = {"notices": self._record.notices}
        student = self._record.register.students.get(_number_or_0(question))
        if student is not None and is_proof(question.get("proof"), student.claim, "nodes"):
            found["nodes"] = self._attendance.nodes.listed(student.number)[0]
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
        is_reassigned = student is not None and self._record.assign(number, student.machine)
        self._record.save()
        if student is None:
            self._attendance.forget(number)
        else:
            self._attendance.watch(number)
        if is_reassigned:
            self._apply()

    def _answer_command(self, question: Document) -> Document:
        verbs = {
            "list": self._list,
            "say": self._say,
            "free": self._free,
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
        text = f'the class "{self._record.name}" is closed'
        notice = {"text": text, "time": time.time(), "closed": True}
        self._serving.session.put(NOTICE_KEY, json.dumps(notice))
        # This waits until the laptops have received the notice: they answer after it.
        self._attendance.refresh()
        return {"heard": len(self._attendance.present())}

    def _free(self, question: Document) -> Document:
        number = _number(question.get("number"))
        student = self._record.register.free(number)
        if student is None:
            return {"error": f"no student has number {number}"}
        self._record.renew(number)
        self._on_claim(number)
        self._apply()
        return {"freed": number, "name": student.name}

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
        """Save the rules and reopen the hub, because Zenoh reads rules when a session opens."""
        assert self._serving is not None
        self._record.save()
        membership.save_users(self._record.users())
        self._serving.reopen()


def _number_or_0(question: Document) -> int:
    number = question.get("number")
    return number if isinstance(number, int) else 0


def _number(value: object) -> int:
    if not isinstance(value, int) or not 1 <= value <= MAX_DOMAIN_ID:
        raise NumberError(value)
    return value
