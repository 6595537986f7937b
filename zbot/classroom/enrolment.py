"""Laptop's side of the enrolment in a class."""

from __future__ import annotations

import time
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from zbot.classroom.admission import release_proof
from zbot.classroom.errors import NoHubError, PinNeededError, RefusedError, SilentHubError
from zbot.classroom.hub_queries import ask
from zbot.classroom.keys import ADMISSION_KEY
from zbot.classroom.link import PLAINTEXT, Link
from zbot.classroom.register import clean_name, clean_sentence
from zbot.security.access import LOBBY, LOBBY_SECRET, credentials
from zbot.security.pin import PinClient, WrongPinError
from zbot.security.secret import Secret
from zbot.transport.membership import Membership
from zbot.transport.session import open_hub_client

if TYPE_CHECKING:
    from collections.abc import Callable

    import zenoh

    from zbot.classroom.address import Address
    from zbot.classroom.admission import AdmissionRequest

    AskPin = Callable[[str], str | None]

_ANSWER_TIMEOUT_S = 5.0
_RELEASE_TIMEOUT_S = 1.0
_LONGEST_WAIT_S = 30.0  # after too many wrong PINs in the class, every laptop must wait


def request_admission(
    address: Address, request: AdmissionRequest, ask_pin: AskPin, link: Link = PLAINTEXT
) -> Membership:
    """Join the class of the hub at an address, or only the hub if it has no class.

    Args:
        address: Address of the hub.
        request: The student's name and number.
        ask_pin: Called with the class's name if the class has a PIN. Returns the PIN, or `None` if
            it is unknown.
        link: Plain TCP or TLS.

    Returns:
        The membership in the class or the hub. Without a class, the membership has no number.

    Raises:
        NoHubError: The program at the address is not a hub.
        WrongPinError: The PIN is wrong.
        PinNeededError: `ask_pin` returned `None`.
        RefusedError: The number is taken or invalid.
        SilentHubError: The class does not answer.
    """
    # A hub with users refuses clients without a user name. A hub without users refuses clients
    # with a user name.
    for settings in ({}, credentials(LOBBY, LOBBY_SECRET)):
        session = open_hub_client(link.endpoint(address), {**settings, **link.settings})
        if session is not None:
            with session:
                return _Enrolment(session, address, is_class=bool(settings)).enrol(request, ask_pin)
    raise NoHubError(address.host, address.port)


class _Enrolment:
    def __init__(self, session: zenoh.Session, address: Address, *, is_class: bool) -> None:
        self._session = session
        self._address = address
        self._is_class = is_class  # only the hub of a class has users

    def enrol(self, request: AdmissionRequest, ask_pin: AskPin) -> Membership:
        begun = time.monotonic()
        greetings = ask(self._session, ADMISSION_KEY, {"op": "hello"}, timeout_s=_ANSWER_TIMEOUT_S)
        if not greetings:
            if self._is_class or time.monotonic() - begun > _ANSWER_TIMEOUT_S / 2:
                raise SilentHubError(self._address.host, self._address.port)
            # The query ended before its timeout, so there is no queryable for admission.
            return Membership("partner", self._address.host, self._address.port)
        hello = greetings[0]
        pin = ask_pin(clean_name(str(hello.get("class")))) if hello.get("pin") else ""
        if pin is None:
            raise PinNeededError
        client = PinClient(Secret(pin))
        challenge = self._ask("enrol", client.hello())
        sealed = self._ask("claim", client.claim(challenge, asdict(request)))
        given = client.opened(sealed)
        try:
            return _membership(self._address, given)
        except (KeyError, TypeError, ValueError) as exc:
            raise NoHubError(self._address.host, self._address.port) from exc

    def _ask(self, verb: str, question: dict[str, Any]) -> dict[str, Any]:
        deadline = time.monotonic() + _LONGEST_WAIT_S
        while True:
            question["op"] = verb
            answers = ask(self._session, ADMISSION_KEY, question, timeout_s=_ANSWER_TIMEOUT_S)
            if not answers:
                raise SilentHubError(self._address.host, self._address.port)
            wait_s = _wait_s(answers[0])
            if wait_s is None or time.monotonic() + wait_s > deadline:
                return _checked(answers[0])
            time.sleep(wait_s)


def _wait_s(answer: dict[str, Any]) -> float | None:
    wait_s = answer.get("wait_s")
    if not isinstance(wait_s, (int, float)) or not 0 <= wait_s <= _LONGEST_WAIT_S:
        return None
    return wait_s


def _checked(answer: dict[str, Any]) -> dict[str, Any]:
    kind = answer.get("refused")
    if kind == "pin":
        raise WrongPinError
    if kind is not None:
        raise RefusedError(str(kind), clean_sentence(str(answer.get("sentence"))))
    return answer


def _membership(address: Address, given: dict[str, Any]) -> Membership:
    return Membership(
        "student",
        address.host,
        address.port,
        class_name=clean_name(str(given["class"])),
        number=int(given["number"]),
        name=clean_name(str(given["name"])),
        user=str(given.get("user", "")),
        secret=str(given.get("secret", "")),
        claim=str(given["claim"]),
        hub_id=str(given["hub_id"]),
    )


def release(session: zenoh.Session, joined: Membership) -> bool:
    """Release this laptop's number. Return whether the class confirmed the release.

    Args:
        session: A client of this machine's hub.
        joined: The membership in the class.
    """
    question = {
        "op": "release",
        "number": joined.number,
        "proof": release_proof(joined.claim),
    }
    answers = ask(session, ADMISSION_KEY, question, timeout_s=_RELEASE_TIMEOUT_S)
    return any(answer.get("released") is True for answer in answers)
