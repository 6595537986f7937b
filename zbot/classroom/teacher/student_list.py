"""List of the students of a class: who has which number, secret and name, and who is here.

This module does not use the network.
"""

from __future__ import annotations

import hashlib
import hmac
import threading
import time
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from zbot.classroom.join_request import is_proof
from zbot.classroom.teacher.student import Identity, Laptop, Student, user_of
from zbot.classroom.teacher.student_number import student_for
from zbot.threads.deadline import Deadline

if TYPE_CHECKING:
    from zbot.classroom.join_request import JoinRequest

_ID_DIGITS = 31  # digits after the first: Zenoh's ids have 16 bytes, which are 32 hex digits
# A laptop that joins needs less than 20 s until its hub is linked (see `student.joining`). After
# this time, the class frees the number of a laptop that never was.
_JOINING_S = 60.0
_RETURN_S = 5.0  # laptops reconnect within a second after the hub was reopened


class StudentList:
    """List of the students of a class. All methods may be called from any thread.

    Args:
        master: The key from which all secrets of the class are derived.
        expected: The names that the teacher expects, by number.
    """

    def __init__(self, master: str, expected: dict[int, str] | None = None) -> None:
        self._master = master
        self.expected = expected or {}
        self._students: dict[int, Student] = {}
        self._machines: dict[int, str] = {}  # the machine that has a number's secret
        self._renewals: dict[int, int] = {}  # how often a number got another owner
        self._laptops: dict[int, Laptop] = {}
        self._joining: dict[int, float] = {}  # when laptops joined that were not linked yet
        self._unconfirmed: set[int] = set()  # laptops that were here before the hub was reopened
        self._confirm_by = Deadline(0)
        self._lock = threading.RLock()

    @classmethod
    def of(cls, document: dict[str, Any]) -> StudentList:
        """Return the list in the document of a class's file, see `document`.

        Raises:
            KeyError: A part is missing.
            ValueError: A number is not valid.
            TypeError: A part has another type.
            AttributeError: As above.
        """
        register = document.pop("register")
        found = cls(document.pop("master"), _by_number(register["expected"]))
        students = _by_number(register["students"])
        found._students = {number: Student(**fields) for number, fields in students.items()}
        found._machines = _by_number(document.pop("holders"))
        found._renewals = _by_number(document.pop("renewals"))
        return found

    def document(self) -> dict[str, Any]:
        """Return the list for the class's file. It contains the key of all secrets."""
        with self._lock:
            students = {number: asdict(student) for number, student in self._students.items()}
            return {
                "master": self._master,
                "register": {"expected": dict(self.expected), "students": students},
                "holders": dict(self._machines),
                "renewals": dict(self._renewals),
            }

    # -- numbers and names -------------------------------------------------------------------------

    def admit(self, request: JoinRequest) -> Student:
        """Give a number, a name and an identity to a laptop, and return its student.

        If another machine knows the number's secret, the number gets its next identity.

        Raises:
            ClassroomError: The laptop does not get the number (see `student_for`).
        """
        with self._lock:
            student = student_for(request, self._students, self.expected)
            for number, other in list(self._students.items()):
                if other.machine == request.machine and number != student.number:
                    self.free(number)
            self._students[student.number] = student
            self._joining[student.number] = time.monotonic()
            if self._machines.get(student.number, student.machine) != student.machine:
                self.renew(student.number)
            self._machines[student.number] = student.machine
            return student

    def free(self, number: int) -> Student | None:
        """Free a number. Return the student who had it, or `None` if it was free."""
        with self._lock:
            self._joining.pop(number, None)
            self._laptops.pop(number, None)
            return self._students.pop(number, None)

    def free_never_linked(self) -> list[int]:
        """Free the numbers of laptops that have joined, but were never linked with the class."""
        late_s = time.monotonic() - _JOINING_S
        with self._lock:
            late = [number for number, since_s in self._joining.items() if since_s <= late_s]
            for number in late:
                del self._joining[number]
            freed = [number for number in late if not self.laptop(number).is_here]
            for number in freed:
                self.free(number)
        return freed

    def begin_period(self, expected: dict[int, str]) -> None:
        """Free all numbers, and let no former owner use its identity any more.

        Args:
            expected: The names that the teacher expects in the new period, by number.
        """
        with self._lock:
            for number in list(self._machines):
                self.renew(number)
            for number in list(self._students):
                self.free(number)
            self.expected = expected

    def students(self) -> list[Student]:
        """Return the students who have joined, in the order of their numbers."""
        with self._lock:
            return [self._students[number] for number in sorted(self._students)]

    def student(self, number: object) -> Student | None:
        """Return the student who has a number, or `None`."""
        return self._students.get(number) if isinstance(number, int) else None

    def missing(self) -> dict[int, str]:
        """Return the expected names whose students have not joined, by number."""
        with self._lock:
            numbers = sorted(self.expected.keys() - self._students.keys())
            return {number: self.expected[number] for number in numbers}

    def namesakes(self, student: Student) -> list[int]:
        """Return the numbers of the other students who have the name of this student."""
        name = student.name.casefold()
        others = [other for other in self.students() if other.number != student.number]
        return [other.number for other in others if other.name.casefold() == name]

    def owner(self, question: dict[str, Any], purpose: str) -> Student | None:
        """Return the student whose laptop sent a query, or `None` if its proof is wrong.

        Args:
            question: The query, with the student's number and the proof.
            purpose: What the query asks for, see `proof`.
        """
        student = self.student(question.get("number"))
        if student is None or not is_proof(question.get("proof"), student.claim, purpose):
            return None
        return student

    # -- secrets -----------------------------------------------------------------------------------

    def secret_of(self, user: str) -> str:
        """Return a user's secret. Calls with the same name return the same secret."""
        return hmac.new(self._master.encode(), user.encode(), hashlib.sha256).hexdigest()

    def renewals(self) -> dict[int, int]:
        """Return how often each number got another owner."""
        with self._lock:
            return dict(self._renewals)

    def renew(self, number: int) -> None:
        """Give a number its next identity. The identity of the number's former owner ends."""
        with self._lock:
            self._renewals[number] = self._renewals.get(number, 0) + 1
            self._machines.pop(number, None)

    def identity(self, number: int, renewals: int | None = None) -> Identity:
        """Return the identity that a number has now, or after some renewals."""
        times = self._renewals.get(number, 0) if renewals is None else renewals
        user = user_of(number) + f"-{times}" * bool(times)
        hub_id = "f" + self.secret_of(f"hub of {user}")[:_ID_DIGITS]
        return Identity(user, self.secret_of(user), hub_id)

    # -- who is here -------------------------------------------------------------------------------

    def note_seen(self, number: int, *, is_here: bool) -> None:
        """Note that a laptop has connected or disconnected."""
        with self._lock:
            self._unconfirmed.discard(number)
            laptop = self._laptops.setdefault(number, Laptop())
            if laptop.is_here != is_here:
                laptop.is_here, laptop.since_ns = is_here, time.time_ns()

    def note_linked(self, number: int) -> None:
        """Note that the hub of a laptop that joins was linked with the class."""
        with self._lock:
            self._joining.pop(number, None)

    def expect_return(self) -> None:
        """Take laptops for gone that are not seen again within 5 s, as the hub was reopened."""
        with self._lock:
            self._unconfirmed = {n for n, laptop in self._laptops.items() if laptop.is_here}
            self._confirm_by = Deadline(_RETURN_S)

    def laptop(self, number: int) -> Laptop:
        """Return when a laptop was seen, and what it has reported."""
        with self._lock:
            self._drop_unconfirmed()
            return self._laptops.setdefault(number, Laptop())

    def here(self) -> list[int]:
        """Return the numbers of the connected laptops."""
        with self._lock:
            self._drop_unconfirmed()
            return [number for number, laptop in self._laptops.items() if laptop.is_here]

    def _drop_unconfirmed(self) -> None:
        if self._confirm_by.is_over:
            for number in self._unconfirmed & self._laptops.keys():
                laptop = self._laptops[number]
                laptop.is_here, laptop.since_ns = False, time.time_ns()
            self._unconfirmed = set()


def _by_number(document: dict[str, Any]) -> dict[int, Any]:
    return {int(number): value for number, value in document.items()}
