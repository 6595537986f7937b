"""Service of a class for laptops that join and leave. Other laptops may query only this service.

Each query and reply is a JSON object. `hello` returns the name of the class. `enrol` and `claim`
are the two steps of the PIN check (`zbot.security.pin`). After these steps the student has a number
and a secret. `release` frees a number. `member` returns whether a laptop is still in the class. A
class without a PIN uses the same steps with an empty PIN.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.classroom.errors import RefusedError
from zbot.classroom.join_request import Document, JoinRequest
from zbot.errors import SetupError
from zbot.security.pin import PinServer, TooManyGuessesError, WrongPinError
from zbot.security.secret import Secret
from zbot.version import __version__

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.classroom.teacher.student_list import StudentList


class JoinService:
    """Service that lets laptops join and leave a class.

    Args:
        class_name: The class's name, which `hello` returns.
        pin: The class's PIN. Empty if the class has no PIN.
        students: The list of the class.
        is_own_hub: Takes the identity of the hub that a laptop has connected to (see
            `hub_identity`), and returns whether this hub is the class's hub.
        credentials: Takes a number and returns the credentials that its laptop needs for the hub.
            If the hub does not accept them yet, it raises `RefusedError`.
        changed: Called with a student's number after the list has changed.
    """

    def __init__(
        self,
        class_name: str,
        pin: str,
        students: StudentList,
        *,
        is_own_hub: Callable[[str], bool],
        credentials: Callable[[int], Document],
        changed: Callable[[int], None],
    ) -> None:
        self._class_name = class_name
        self._has_pin = bool(pin)
        self._pin_server = PinServer(Secret(pin), class_name, is_own_hub)
        self._students = students
        self._credentials = credentials
        self._changed = changed

    def answer(self, question: Document) -> Document:
        """Return the reply to a query. A refusal is `{"refused": kind, "sentence": reason}`."""
        steps = {
            "hello": self._hello,
            "enrol": self._pin_server.challenge,
            "claim": self._claim,
            "release": self._release,
            "member": self._member,
        }
        step = steps.get(str(question.get("op")))
        if step is None:
            return {"refused": "question", "sentence": "the class does not understand the request"}
        try:
            return step(question)
        except SetupError as error:
            wait_s = getattr(error, "wait_s", None)
            known = getattr(error, "known", None)
            kind = _kind(error)
            return {"refused": kind, "sentence": str(error), "wait_s": wait_s, "known": known}

    def _hello(self, _question: Document) -> Document:
        return {"class": self._class_name, "pin": self._has_pin, "version": __version__}

    def _claim(self, question: Document) -> Document:
        admission = self._pin_server.admit(question)
        request = JoinRequest.of(admission.request)
        self._check_copied(request.machine)
        student = self._students.admit(request)
        self._changed(student.number)
        return admission.seal(
            {
                "class": self._class_name,
                "number": student.number,
                "name": student.name,
                "claim": student.claim,
                **self._credentials(student.number),
            }
        )

    def _check_copied(self, machine: str) -> None:
        for student in self._students.students():
            if student.machine == machine and self._students.laptop(student.number).is_here:
                raise RefusedError(
                    "copied",
                    f"the laptop of {student.name} (number {student.number}) is connected and has "
                    "the identifier of this laptop: both may have been copied from one image",
                )

    def _release(self, question: Document) -> Document:
        student = self._students.owner(question, "release")
        if student is None:
            return {"released": False}
        self._students.free(student.number)
        self._changed(student.number)
        return {"released": True}

    def _member(self, question: Document) -> Document:
        return {"member": self._students.owner(question, "member") is not None}


def _kind(error: SetupError) -> str:
    """Return the value of `refused` in the reply about an error."""
    if isinstance(error, RefusedError):
        return error.kind
    if isinstance(error, TooManyGuessesError):
        return "wait"
    return "pin" if isinstance(error, WrongPinError) else "question"
