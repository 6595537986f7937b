"""Where laptops ask to be let into a class: the only thing that a stranger may speak to.

Each question and answer is a JSON object. `hello` tells what class it is; `enrol` and `prove` are
the two steps of the exchange in `pake`, at whose end the student gets number and secret; `release`
gives a number back.
"""

from __future__ import annotations

import secrets
import time
from collections import OrderedDict
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot.classroom import pake
from zbot.classroom.errors import ClassroomError
from zbot.classroom.register import Register, Student, TakenError, clean_name
from zbot.version import __version__

if TYPE_CHECKING:
    from collections.abc import Callable

#: The user that anybody may be; it reaches nothing but the door.
GUEST = "guest"
GUEST_SECRET = "guest"  # noqa: S105 - everybody knows it

_MOST_VISITS = 256  # the oldest is forgotten: whoever began it begins again
_FREE_FAILURES = 10
_FORGIVEN_AFTER_S = 600.0
# With six digits, somebody who tries a PIN each two seconds needs twelve days for half of them.
_PAUSE_AFTER_FAILURES_S = 2.0
_MACHINE_LENGTH = 64

Question = dict[str, Any]
Answer = dict[str, Any]


@dataclass(frozen=True)
class _Visit:
    key: bytes
    number: int | None
    name: str | None
    machine: str
    host: str

    @property
    def facts(self) -> list[Any]:
        return [self.number, self.name, self.machine, self.host]


class Throttle:
    """Slows guessing down: after ten wrong PINs, one try each two seconds is looked at.

    Args:
        now_s: A clock that never goes back, in seconds.
    """

    def __init__(self, now_s: Callable[[], float] = time.monotonic) -> None:
        self._now_s = now_s
        self._failures: list[float] = []
        self._last_try_s = float("-inf")

    def wait_s(self) -> float:
        """Return how long to wait before the next try; 0 if it is let through, and counted."""
        now = self._now_s()
        self._failures = [one for one in self._failures if now - one < _FORGIVEN_AFTER_S]
        ready = self._last_try_s + _PAUSE_AFTER_FAILURES_S
        if len(self._failures) >= _FREE_FAILURES and now < ready:
            return ready - now
        self._last_try_s = now
        return 0.0

    def fail(self) -> None:
        """Count a wrong PIN."""
        self._failures.append(self._now_s())
        del self._failures[: -2 * _FREE_FAILURES]


class Door:
    """Lets laptops in.

    Args:
        class_name: Told to whoever asks.
        pin: The class's; empty if it has none.
        register: Where numbers are claimed.
        secret_of: Returns user name and secret of a number.
        changed: Called after the register has changed, with the number.
        throttle: Slows guessing down.
    """

    def __init__(
        self,
        class_name: str,
        pin: str,
        register: Register,
        *,
        secret_of: Callable[[int], tuple[str, str]],
        changed: Callable[[int], None],
        throttle: Throttle | None = None,
    ) -> None:
        self._class_name = class_name
        self._has_pin = bool(pin)
        self._verifier = pake.Verifier.of(pin)
        self._register = register
        self._secret_of = secret_of
        self._changed = changed
        self._throttle = throttle or Throttle()
        self._visits: OrderedDict[str, _Visit] = OrderedDict()

    def answer(self, question: Question) -> Answer:
        """Answer a question; one that makes no sense gets `{"refused": "question"}`."""
        steps = {
            "hello": self._hello,
            "enrol": self._enrol,
            "prove": self._prove,
            "release": self._release,
        }
        step = steps.get(str(question.get("op")))
        if step is None:
            return {"refused": "question", "sentence": "the class does not understand the question"}
        try:
            return step(question)
        except pake.ProofError:
            return _wrong_pin()
        except ClassroomError as error:
            kind = "taken" if isinstance(error, TakenError) else "number"
            return {"refused": kind, "sentence": str(error)}

    def _hello(self, _question: Question) -> Answer:
        return {"class": self._class_name, "pin": self._has_pin, "version": __version__}

    def _enrol(self, question: Question) -> Answer:
        side = pake.TeacherSide(self._verifier, question.get("public"))
        number = question.get("number")
        name = clean_name(str(question.get("name") or "")) or None
        visit = _Visit(
            side.key,
            number if isinstance(number, int) else None,
            name,
            str(question.get("machine"))[:_MACHINE_LENGTH],
            clean_name(str(question.get("host"))) or "a laptop",
        )
        ticket = secrets.token_hex(8)
        self._visits[ticket] = visit
        if len(self._visits) > _MOST_VISITS:
            self._visits.popitem(last=False)
        return {"visit": ticket, "salt": self._verifier.salt.hex(), "public": side.public}

    def _prove(self, question: Question) -> Answer:
        wait_s = self._throttle.wait_s()
        if wait_s > 0:
            return {"refused": "wait", "wait_s": wait_s}
        visit = self._visits.pop(str(question.get("visit")), None)
        if visit is None:
            return {"refused": "visit", "sentence": "the class forgot this visit: try again"}
        if not pake.is_proof(visit.key, question.get("proof"), *visit.facts):
            self._throttle.fail()
            return _wrong_pin()
        student = self._register.claim(visit.number, visit.name, visit.machine, visit.host)
        self._changed(student.number)
        return pake.seal(visit.key, self._welcome(student))

    def _welcome(self, student: Student) -> dict[str, Any]:
        user, secret = self._secret_of(student.number)
        return {
            "class": self._class_name,
            "number": student.number,
            "name": student.name,
            "claim": student.claim,
            "user": user,
            "secret": secret,
        }

    def _release(self, question: Question) -> Answer:
        number = question.get("number")
        student = self._register.students.get(number) if isinstance(number, int) else None
        if student is None:
            return {"released": False}
        _, secret = self._secret_of(student.number)
        if not pake.is_proof(secret.encode(), question.get("proof"), "release", student.claim):
            return {"released": False}
        self._register.free(student.number)
        self._changed(student.number)
        return {"released": True}


def _wrong_pin() -> Answer:
    return {"refused": "pin", "sentence": "the PIN is wrong: ask the teacher for it"}
