"""Where laptops ask to be let into a class: the only thing that a stranger may speak to.

Each question and answer is a JSON object. `hello` tells what class it is; `enrol` and `claim` carry
the two steps of the PIN check (`zbot.security.pin`), at whose end the student gets number and
secret; `release` gives a number back. A class without a PIN goes the same way, with an empty one.
"""

from __future__ import annotations

import hmac
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot.classroom.register import Register, TakenError, clean_name
from zbot.errors import SetupError
from zbot.security.pin import PinServer, TooManyGuessesError, WrongPinError
from zbot.security.secret import Secret
from zbot.version import __version__

if TYPE_CHECKING:
    from collections.abc import Callable

_MACHINE_LENGTH = 64

Document = dict[str, Any]

# What a refusal is called, by the error that it comes from; the sentence goes along.
_REFUSALS: tuple[tuple[type[SetupError], str], ...] = (
    (WrongPinError, "pin"),
    (TooManyGuessesError, "wait"),
    (TakenError, "taken"),
    (SetupError, "question"),
)


@dataclass(frozen=True)
class AdmissionRequest:
    """What a student would like to be."""

    machine: str  #: tells this laptop from others
    host: str  #: what the laptop calls itself
    name: str | None = None  #: the student's
    number: int | None = None  #: the student's; the class chooses one if it is left out

    @classmethod
    def of(cls, document: Document) -> AdmissionRequest:
        """Read what came from a laptop; what makes no sense is left out."""
        number = document.get("number")
        return cls(
            str(document.get("machine"))[:_MACHINE_LENGTH],
            clean_name(str(document.get("host") or "")) or "a laptop",
            clean_name(str(document.get("name") or "")) or None,
            number if isinstance(number, int) else None,
        )


def release_proof(claim: str) -> str:
    """Return what shows that whoever gives a number back is the one who has it.

    The claim came sealed, so nobody else knows it.
    """
    return hmac.new(claim.encode(), b"release", "sha256").hexdigest()


class AdmissionService:
    """Lets laptops in.

    Args:
        class_name: Told to whoever asks.
        pin: The class's; empty if it has none.
        register: Where numbers are claimed.
        credentials: Returns what a laptop with a number needs to be let through.
        changed: Called after the register has changed, with the number.
    """

    def __init__(
        self,
        class_name: str,
        pin: str,
        register: Register,
        *,
        credentials: Callable[[int], Document],
        changed: Callable[[int], None],
    ) -> None:
        self._class_name = class_name
        self._has_pin = bool(pin)
        self._pin_door = PinServer(Secret(pin))
        self._register = register
        self._credentials = credentials
        self._changed = changed

    def answer(self, question: Document) -> Document:
        """Answer a question; a refusal is `{"refused": kind, "sentence": why}`."""
        steps = {
            "hello": self._hello,
            "enrol": self._pin_door.challenge,
            "claim": self._claim,
            "release": self._release,
        }
        step = steps.get(str(question.get("op")))
        if step is None:
            return {"refused": "question", "sentence": "the class does not understand the question"}
        try:
            return step(question)
        except SetupError as error:
            kind = next(word for known, word in _REFUSALS if isinstance(error, known))
            wait_s = getattr(error, "wait_s", None)
            return {"refused": kind, "sentence": str(error), "wait_s": wait_s}

    def _hello(self, _question: Document) -> Document:
        return {"class": self._class_name, "pin": self._has_pin, "version": __version__}

    def _claim(self, question: Document) -> Document:
        admission = self._pin_door.admit(question)
        wish = AdmissionRequest.of(admission.wish)
        student = self._register.claim(wish.number, wish.name, wish.machine, wish.host)
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

    def _release(self, question: Document) -> Document:
        number = question.get("number")
        student = self._register.students.get(number) if isinstance(number, int) else None
        if student is None:
            return {"released": False}
        proof = release_proof(student.claim)
        given = str(question.get("proof")).encode(errors="backslashreplace")
        if not hmac.compare_digest(proof.encode(), given):
            return {"released": False}
        self._register.free(student.number)
        self._changed(student.number)
        return {"released": True}
