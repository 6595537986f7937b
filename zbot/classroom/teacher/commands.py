"""Commands of the teacher to a running class, such as `list`, `say` and `free`."""

from __future__ import annotations

import contextlib
import json
import time
from typing import TYPE_CHECKING

from zbot.classroom.errors import ClassroomError
from zbot.classroom.teacher.class_record import MAX_NOTICES, ClassRecord
from zbot.classroom.teacher.student_number import validated_number
from zbot.log.teacher_notice import NOTICE_KEY

if TYPE_CHECKING:
    import threading
    from collections.abc import Callable

    from zbot.classroom.hub.process import HubProcess
    from zbot.classroom.join_request import Document
    from zbot.classroom.teacher.laptops import Laptops
    from zbot.classroom.teacher.robots import Robots
    from zbot.classroom.teacher.student import Student

_AGAIN = "type `zbot leave`, and join again if you take part"


class ClassCommands:
    """Commands that change or show an open class.

    Args:
        record: The class's data.
        laptops: The laptops of the students.
        robots: The robots of the class.
        lock: Held while a command or a laptop changes the class.
        apply: Saves the data, and reopens the hub with them.
    """

    def __init__(
        self,
        record: ClassRecord,
        laptops: Laptops,
        robots: Robots,
        lock: threading.RLock,
        *,
        apply: Callable[[], None],
    ) -> None:
        self._record, self._students = record, record.students
        self._laptops, self._robots = laptops, robots
        self._lock, self._apply = lock, apply
        self._serving: HubProcess | None = None

    def attach(self, serving: HubProcess) -> None:
        """Use a hub that was opened."""
        self._serving = serving

    def answer(self, question: Document) -> Document:
        """Return the reply to a command. A refusal is `{"error": reason}`."""
        verbs = {
            "list": self._list,
            "say": self._say,
            "free": self._free,
            "next": self._next,
            "share": self._share,
            "open": self._open,
            "sensors": self._sensors,
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
            for number in self._students.free_never_linked():
                self._laptops.forget(number)
                self._record.save()
        self._laptops.refresh()
        return {
            "class": self._record.name,
            "students": [self._row(student) for student in self._students.students()],
            "expected": [
                {"number": number, "name": name}
                for number, name in self._students.missing().items()
            ],
            "students_can_publish": self._record.is_open,
            "shares": [list(share) for share in self._record.shares],
            "robots": [
                {"name": name, "driver": self._robots.drivers.get(name)}
                for name in self._robots.connected()
            ],
        }

    def _row(self, student: Student) -> Document:
        nodes, more_nodes = self._laptops.nodes.listed(student.number)
        laptop = self._students.laptop(student.number)
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
        return {"heard": len(self._students.here())}

    def _close(self, _question: Document) -> Document:
        """Tell all students that the class is closed. The teacher's command then ends the hub."""
        assert self._serving is not None
        self._notify(f'the class "{self._record.name}" is closed', closed=True)
        return {"heard": len(self._students.here())}

    def _notify(self, text: str, **more: bool) -> None:
        """Send a notice, and wait until the laptops have received it."""
        assert self._serving is not None
        notice = {"text": text, "time": time.time(), **more}
        self._serving.session.put(NOTICE_KEY, json.dumps(notice))
        self._laptops.refresh()  # the laptops answer after they have received the notice

    def _free(self, question: Document) -> Document:
        number = validated_number(question.get("number"))
        is_here = self._students.laptop(number).is_here
        student = self._students.free(number)
        if student is None:
            return {"error": f"no student has number {number}"}
        self._students.renew(number)
        self._laptops.forget(number)
        self._apply()
        return {"freed": number, "name": student.name, "host": student.host, "here": is_here}

    def _next(self, question: Document) -> Document:
        """Begin a new period: free all numbers. The name, the code and the PIN stay the same."""
        assert self._serving is not None
        students = self._students.students()
        self._notify(f'a new period of the class "{self._record.name}" has begun: {_AGAIN}')
        given = question.get("expected")
        expected = self._students.expected if given is None else _expected(given)
        for robot in self._robots.drivers:
            self._robots.give(robot, None)
        self._robots.publish(self._serving.session)
        self._record.begin_period(expected)
        for student in students:
            self._laptops.forget(student.number)
        self._apply()
        return {"class": self._record.name, "freed": len(students)}

    def _robot(self, question: Document) -> Document:
        """Note that a robot's bridge runs, and return the number of the student who drives."""
        return {"driver": self._robots.note(str(question.get("robot")))}

    def _give(self, question: Document) -> Document:
        """Let one student drive a robot. Without a number, nobody drives."""
        assert self._serving is not None
        robot, given = str(question.get("robot")), question.get("number")
        number = None if given is None else validated_number(given)
        student = None if number is None else self._students.student(number)
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
        share = (validated_number(question.get("owner")), validated_number(question.get("reader")))
        others = [known for known in self._record.shares if known != share]
        self._record.shares = [*others, share] if question.get("on", True) else others
        self._apply()
        return {"shares": [list(known) for known in self._record.shares]}

    def _open(self, question: Document) -> Document:
        self._record.is_open = bool(question.get("on", True))
        self._apply()
        return {"open": self._record.is_open}

    def _sensors(self, question: Document) -> Document:
        """Allow or forbid that pages publish the sensors of browsers. The pages ask for this."""
        self._record.has_sensors = bool(question.get("on", True))
        self._record.save()
        return {"sensors": self._record.has_sensors}


def _expected(given: object) -> dict[int, str]:
    """Return the names by number in a command. Names come from the teacher's own file."""
    document = given if isinstance(given, dict) else {}
    return {int(number): str(name) for number, name in document.items()}
