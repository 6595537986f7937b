"""Laptop's side of the enrolment in a class."""

from __future__ import annotations

import re
import time
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from zbot.classroom.admission import proof
from zbot.classroom.errors import NoHubError, PinNeededError, RefusedError, SilentHubError
from zbot.classroom.hub_identity import certificate_identity, dialled_identity
from zbot.classroom.hub_queries import ask
from zbot.classroom.keys import ADMISSION_KEY
from zbot.classroom.link import PLAINTEXT, Link
from zbot.classroom.register import clean_name, clean_sentence
from zbot.security.access import LOBBY, LOBBY_SECRET, credentials
from zbot.security.pin import PinClient, WrongPinError
from zbot.security.secret import Secret
from zbot.transport.config import MAX_DOMAIN_ID
from zbot.transport.membership import Membership
from zbot.transport.session import open_hub_client

if TYPE_CHECKING:
    from collections.abc import Callable

    import zenoh

    from zbot.classroom.address import Address
    from zbot.classroom.admission import AdmissionRequest

    AskPin = Callable[[str], str | None]

_ANSWER_TIMEOUT_S = 5.0
_WORD = re.compile("[0-9A-Za-z_-]{0,128}")
_RELEASE_TIMEOUT_S = 1.0
_LONGEST_WAIT_S = 30.0  # after too many wrong PINs in the class, every laptop must wait


def request_admission(
    address: Address,
    request: AdmissionRequest,
    ask_pin: AskPin,
    link: Link = PLAINTEXT,
    certificate: str = "",
) -> Membership:
    """Join the class of the hub at an address, or only the hub if it has no class.

    Args:
        address: Address of the hub.
        request: The student's name and number.
        ask_pin: Called with the class's name if the class has a PIN. Returns the PIN, or `None` if
            it is unknown.
        link: Plain TCP or TLS.
        certificate: Fingerprint of the certificate that the hub has shown, if the link uses TLS.

    Returns:
        The membership in the class or the hub. Without a class, the membership has no number.

    Raises:
        NoHubError: The program at the address is not a hub.
        WrongPinError: The PIN is wrong.
        PinError: The PIN could not be checked. The message says why.
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
                hub = (
                    certificate_identity(certificate) if certificate else dialled_identity(session)
                )
                enrolment = _Enrolment(session, address, hub, is_class=bool(settings))
                return enrolment.enrol(request, ask_pin)
    raise NoHubError(address.host, address.port)


class _Enrolment:
    def __init__(
        self, session: zenoh.Session, address: Address, hub: str, *, is_class: bool
    ) -> None:
        self._session = session
        self._hub = hub
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
        class_name = str(hello.get("class"))
        pin = ask_pin(clean_name(class_name)) if hello.get("pin") else ""
        if pin is None:
            raise PinNeededError
        client = PinClient(Secret(pin), class_name, self._hub)
        challenge = self._ask("enrol", client.hello())
        sealed = self._ask("claim", client.claim(challenge, asdict(request)))
        given = client.opened(sealed)
        try:
            return membership_from(self._address, given)
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
        known = clean_name(str(answer.get("known") or ""))
        raise RefusedError(str(kind), clean_sentence(str(answer.get("sentence"))), known)
    return answer


def membership_from(address: Address, given: dict[str, Any]) -> Membership:
    """Return the membership that a class's answer contains.

    Raises:
        KeyError: A part is missing.
        ValueError: A part has an unexpected form.
    """
    number = given["number"]
    if not isinstance(number, int) or not 1 <= number <= MAX_DOMAIN_ID:
        raise ValueError(f"{number!r} is not a number of a student")
    return Membership(
        "student",
        address.host,
        address.port,
        class_name=clean_name(str(given["class"])),
        number=number,
        name=clean_name(str(given["name"])),
        user=_word(given.get("user", "")),
        secret=_word(given.get("secret", "")),
        claim=_word(given["claim"]),
        hub_id=_word(given["hub_id"]),
    )


def _word(value: object) -> str:
    # These words become parts of Zenoh's settings and of Zenoh's file of users.
    if not isinstance(value, str) or not _WORD.fullmatch(value):
        raise ValueError(f"{value!r} is not a word of letters and digits")
    return value


def release(session: zenoh.Session, joined: Membership) -> bool:
    """Release this laptop's number. Return whether the class confirmed the release.

    Args:
        session: A client of this machine's hub.
        joined: The membership in the class.
    """
    question = {
        "op": "release",
        "number": joined.number,
        "proof": proof(joined.claim, "release"),
    }
    answers = ask(session, ADMISSION_KEY, question, timeout_s=_RELEASE_TIMEOUT_S)
    return any(answer.get("released") is True for answer in answers)
