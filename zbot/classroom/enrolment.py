"""Asking a class to be let in, from the laptop's side of its door."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

from zbot.classroom import pake
from zbot.classroom.desk import ask
from zbot.classroom.door import GUEST, GUEST_SECRET
from zbot.classroom.errors import (
    NoHubError,
    PinNeededError,
    RefusedError,
    SilentHubError,
    WrongPinError,
)
from zbot.classroom.keys import DOOR_KEY
from zbot.classroom.register import clean_name
from zbot.membership import Membership
from zbot.session import open_hub_client

if TYPE_CHECKING:
    from collections.abc import Callable

    import zenoh

    from zbot.classroom.address import Address

_ANSWER_TIMEOUT_S = 5.0
_LONGEST_WAIT_S = 30.0  # behind somebody who guesses PINs

_GUEST_SETTINGS = {
    "transport/auth/usrpwd/user": GUEST,
    "transport/auth/usrpwd/password": GUEST_SECRET,
}


class Wish:
    """What a student would like to be.

    Args:
        machine: Tells this laptop from others.
        host: What the laptop calls itself.
        name: The student's.
        number: The student's; the class chooses one if it is left out.
    """

    def __init__(
        self, machine: str, host: str, name: str | None = None, number: int | None = None
    ) -> None:
        self.machine, self.host = machine, clean_name(host)
        self.name = clean_name(name or "") or None
        self.number = number

    @property
    def facts(self) -> list[Any]:
        """What the proof of the PIN is bound to."""
        return [self.number, self.name, self.machine, self.host]


def knock(address: Address, wish: Wish, ask_pin: Callable[[str], str | None]) -> Membership:
    """Ask whoever is behind an address to be let in.

    Args:
        address: Of a hub.
        wish: Name and number.
        ask_pin: Called with the class's name if it has a PIN; `None` if nobody knows it.

    Returns:
        What was joined: a class, or a plain hub, which asks nothing.

    Raises:
        NoHubError: It is no hub.
        WrongPinError: Or none was given; `PinNeededError`.
        RefusedError: The number is taken, or there is none like it.
        SilentHubError: The class does not answer.
    """
    session = open_hub_client(address.endpoint, _GUEST_SETTINGS)
    if session is None:
        return _plain_hub(address)
    with session:
        return _Visit(session, address).enrol(wish, ask_pin)


def _plain_hub(address: Address) -> Membership:
    session = open_hub_client(address.endpoint)
    if session is None:
        raise NoHubError(address.host, address.port)
    session.close()
    return Membership("partner", address.host, address.port)


class _Visit:
    def __init__(self, session: zenoh.Session, address: Address) -> None:
        self._session = session
        self._address = address

    def enrol(self, wish: Wish, ask_pin: Callable[[str], str | None]) -> Membership:
        hello = self._ask({"op": "hello"})
        pin = ask_pin(clean_name(str(hello.get("class")))) if hello.get("pin") else ""
        if pin is None:
            raise PinNeededError
        key, welcome = self._prove(wish, pin)
        try:
            given = pake.unseal(key, welcome)
        except pake.ProofError as exc:
            raise WrongPinError from exc
        return _membership(self._address, given)

    def _prove(self, wish: Wish, pin: str) -> tuple[bytes, dict[str, Any]]:
        side = pake.StudentSide()
        request = {"number": wish.number, "name": wish.name, "machine": wish.machine}
        opened = self._ask({"op": "enrol", "public": side.public, "host": wish.host, **request})
        key = side.key(pin, bytes.fromhex(str(opened.get("salt"))), opened.get("public"))
        question = {
            "op": "prove",
            "visit": opened.get("visit"),
            "proof": pake.proof(key, *wish.facts),
        }
        deadline = time.monotonic() + _LONGEST_WAIT_S
        answer = self._ask(question)
        while answer.get("refused") == "wait" and time.monotonic() < deadline:
            time.sleep(min(float(answer.get("wait_s", 1.0)), _LONGEST_WAIT_S))
            answer = self._ask(question)
        _check(answer)
        return key, answer

    def _ask(self, question: dict[str, Any]) -> dict[str, Any]:
        answers = ask(self._session, DOOR_KEY, question, timeout_s=_ANSWER_TIMEOUT_S)
        if not answers:
            raise SilentHubError(self._address.host, self._address.port)
        return answers[0]


def _check(answer: dict[str, Any]) -> None:
    kind = answer.get("refused")
    if kind == "pin":
        raise WrongPinError
    if kind == "wait":
        raise RefusedError("wait", "somebody tries PINs just now: try again in a minute")
    if kind is not None:
        raise RefusedError(str(kind), clean_sentence(answer.get("sentence")))


def clean_sentence(text: object) -> str:
    """Return a sentence of another machine as it may be shown."""
    return " ".join("".join(c if c.isprintable() else " " for c in str(text)).split())[:500]


def _membership(address: Address, given: dict[str, Any]) -> Membership:
    return Membership(
        "student",
        address.host,
        address.port,
        class_name=clean_name(str(given["class"])),
        number=int(given["number"]),
        name=clean_name(str(given["name"])),
        user=str(given["user"]),
        secret=str(given["secret"]),
        claim=str(given["claim"]),
    )


def release(session: zenoh.Session, joined: Membership) -> bool:
    """Give a number back; return whether the class has taken it.

    Args:
        session: A client of this machine's hub.
        joined: The class.
    """
    mark = pake.proof(joined.secret.encode(), "release", joined.claim)
    question = {"op": "release", "number": joined.number, "proof": mark}
    answers = ask(session, DOOR_KEY, question, timeout_s=1.0)
    return any(answer.get("released") is True for answer in answers)
