"""The class itself, in the process of the teacher's hub: its door, and the teacher's desk."""

from __future__ import annotations

import contextlib
import json
import threading
import time
from typing import TYPE_CHECKING, Any

from zbot.classroom.address import EVERYWHERE, Address
from zbot.classroom.admission import AdmissionService
from zbot.classroom.attendance import Attendance
from zbot.classroom.class_record import MOST_NOTICES, ClassRecord, user_of
from zbot.classroom.errors import ClassroomError
from zbot.classroom.hub import HubSettings
from zbot.classroom.keys import DESK_KEY, DOOR_KEY, NOTICES_KEY
from zbot.classroom.link import Link
from zbot.classroom.register import NumberError
from zbot.log.announcement import NOTICE_KEY
from zbot.security.access import TEACHER, Share, teacher_access
from zbot.transport import membership
from zbot.transport.config import MAX_DOMAIN_ID

if TYPE_CHECKING:
    from zbot.classroom.hub_process import HubProcess
    from zbot.classroom.register import Student

Document = dict[str, Any]

_NUMBERS = range(1, MAX_DOMAIN_ID + 1)
# What Linux, macOS and Windows call it.
_LOOPBACK_INTERFACES = ("lo", "lo0", "Loopback Pseudo-Interface 1")


class Classroom:
    """An open class.

    Args:
        record: What it remembers.
        port: The TCP port that it is reached at.
    """

    def __init__(self, record: ClassRecord, port: int) -> None:
        self._record = record
        self._port = port
        self._seats = Attendance()
        self._lock = threading.RLock()  # the door and the desk have threads of their own
        self._serving: HubProcess | None = None
        self._door = AdmissionService(
            record.name,
            record.pin,
            record.register,
            credentials=record.credentials,
            changed=self._on_claim,
        )

    def settings(self) -> HubSettings:
        """Return how the hub is linked, and who may do what through it."""
        link = Link(self._record.keystore)
        listen = link.listening(Address(EVERYWHERE, self._port))
        students = {user_of(number): number for number in _NUMBERS}
        shares = [Share(owner, user_of(reader)) for owner, reader in self._record.shares]
        settings = teacher_access(students, shared_is_open=self._record.is_open, shares=shares)
        if not self._record.pin:
            self._go_by_ids(settings["access_control"])
        settings |= link.settings
        return HubSettings(listen, extra=settings)

    def _go_by_ids(self, access: Document) -> None:
        """Let the rules hold for hubs and this machine, rather than for users with passwords."""
        ids = {user_of(number): self._record.hub_id(number) for number in _NUMBERS}
        for subject in access["subjects"]:
            user = subject["id"]
            del subject["usernames"]
            if user in ids:
                subject["zids"] = [ids[user]]
            elif user == TEACHER:
                subject["interfaces"] = list(_LOOPBACK_INTERFACES)
            # What the lobby may, everybody may: a subject without conditions is anybody.

    def equip(self, serving: HubProcess) -> None:
        """Open the door and the desk."""
        self._serving = serving
        serving.desk(DOOR_KEY, self._answer_door)
        serving.desk(DESK_KEY, self._serve_teacher)
        serving.desk(NOTICES_KEY, lambda _question: {"notices": self._record.notices})
        self._seats.equip(serving, self._record.register.students)

    def _answer_door(self, question: Document) -> Document:
        with self._lock:
            return self._door.answer(question)

    def _on_claim(self, number: int) -> None:
        student = self._record.register.students.get(number)
        changes_hands = student is not None and self._record.hand_to(number, student.machine)
        self._record.save()
        if student is None:
            self._seats.forget(number)
        else:
            self._seats.watch(number)
        if changes_hands:
            self._apply()

    def _serve_teacher(self, question: Document) -> Document:
        verbs = {
            "list": self._list,
            "say": self._say,
            "free": self._free,
            "share": self._share,
            "open": self._open,
        }
        verb = verbs.get(str(question.get("op")))
        if verb is None:
            return {"error": "the class does not know this command: is its zbot older?"}
        # Whoever changes something does so alone; a list may wait for laptops that sleep.
        try:
            with contextlib.nullcontext() if verb == self._list else self._lock:
                return verb(question)
        except ClassroomError as error:
            return {"error": str(error)}

    def _list(self, _question: Document) -> Document:
        self._seats.refresh()
        nodes = self._seats.nodes()
        students = sorted(self._record.register.students.values(), key=lambda one: one.number)
        missing = self._record.register.expected.keys() - self._record.register.students.keys()
        return {
            "class": self._record.name,
            "students": [self._row(one, nodes.get(one.number, [])) for one in students],
            "expected": [
                {"number": number, "name": self._record.register.expected[number]}
                for number in sorted(missing)
            ],
            "open": self._record.is_open,
            "shares": [list(share) for share in self._record.shares],
        }

    def _row(self, student: Student, nodes: list[str]) -> Document:
        seat = self._seats.seat(student.number)
        return {
            "number": student.number,
            "name": student.name,
            "host": student.host,
            "here": seat.is_here,
            "since": seat.since_ns / 1e9 or None,
            "nodes": sorted(nodes),
            "last_error": seat.last_error,
            "clock_offset": seat.clock_offset_s,
            "version": seat.version,
            "system": seat.system,
        }

    def _say(self, question: Document) -> Document:
        assert self._serving is not None
        notice = {"text": str(question.get("text", "")), "time": time.time()}
        self._record.notices = [*self._record.notices, notice][-MOST_NOTICES:]
        self._record.save()
        self._serving.session.put(NOTICE_KEY, json.dumps(notice))
        return {"heard": len(self._seats.present())}

    def _free(self, question: Document) -> Document:
        number = _number(question.get("number"))
        student = self._record.register.free(number)
        if student is None:
            return {"error": f"nobody has number {number}"}
        self._record.renew(number)
        self._on_claim(number)
        self._apply()
        return {"freed": number, "name": student.name}

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
        """Let the hub's rules change: Zenoh reads them when a session opens."""
        assert self._serving is not None
        self._record.save()
        membership.save_users(self._record.users())
        self._serving.reopen()


def _number(value: object) -> int:
    if not isinstance(value, int) or not 1 <= value <= MAX_DOMAIN_ID:
        raise NumberError(value)
    return value
