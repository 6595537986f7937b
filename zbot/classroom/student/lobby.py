"""Lobby of a class: a laptop asks there to join, whether it is still a member, and to leave."""

from __future__ import annotations

import re
import time
from dataclasses import asdict, replace
from typing import TYPE_CHECKING, Any

from zbot.classroom.errors import ClassroomError, NoHubError, RefusedError, SilentHubError
from zbot.classroom.hub.address import Address
from zbot.classroom.hub.link import PLAINTEXT, Link, certificate_identity, dialled_identity
from zbot.classroom.hub.probe import problem_at
from zbot.classroom.hub.queries import ask
from zbot.classroom.join_request import clean_name, proof
from zbot.classroom.keys import ADMISSION_KEY, HUB_KEY
from zbot.security.access import LOBBY, LOBBY_SECRET, credentials
from zbot.security.pin import PinClient, WrongPinError
from zbot.security.secret import Secret
from zbot.text.terminal import single_line
from zbot.threads.deadline import Deadline
from zbot.transport.config import MAX_DOMAIN_ID
from zbot.transport.membership import Membership
from zbot.transport.session import open_hub_client

if TYPE_CHECKING:
    from collections.abc import Callable

    import zenoh

    from zbot.classroom.join_request import JoinRequest

    AskPin = Callable[[str], str | None]

_ANSWER_TIMEOUT_S = 5.0
_WORD = re.compile("[0-9A-Za-z_-]{0,128}")
_RELEASE_TIMEOUT_S = 10.0  # the number of a laptop that gives up too soon stays taken
_MEMBER_TIMEOUT_S = 2.0
_LONGEST_WAIT_S = 30.0  # after too many wrong PINs in the class, every laptop must wait
_REOPENING_S = 5.0  # longest time for which a hub is closed while it is opened again
_REOPENED_PAUSE_S = 0.5
# A hub closes a link that is half open after 3 s.
_OPENING: dict[str, Any] = {"transport/unicast/open_timeout": 3500}
_SILENT_S = 3.0  # a hub that refuses usually closes the link sooner
_MOST_FRUITLESS = 3  # attempts at a hub or a class that does not answer
_MAX_SENTENCE_LENGTH = 500
_MAX_VERSION = 40
_VERSION_TIMEOUT_S = 1.0
_GREETINGS = 3
_GREETING_PAUSE_S = 0.2
# These override the user name of a class that this machine has joined before.
_NOBODY: dict[str, Any] = {
    "transport/auth/usrpwd/user": None,
    "transport/auth/usrpwd/password": None,
}


def request_membership(
    address: Address,
    request: JoinRequest,
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
        ClassroomError: `ask_pin` returned `None`.
        RefusedError: The number is taken or invalid.
        SilentHubError: The class does not answer.
        ClosedPortError: The hub was closed meanwhile.
    """
    # The hub may be reopened meanwhile. A class that is asked again by the same laptop gives the
    # same number.
    deadline, fruitless = Deadline(_LONGEST_WAIT_S), 0
    while True:
        try:
            return _request_once(address, request, ask_pin, link, certificate)
        except RefusedError as error:
            if error.wait_s is None or error.wait_s > deadline.left_s:
                raise
            time.sleep(error.wait_s)
        except (NoHubError, SilentHubError):
            fruitless += 1
            if fruitless == _MOST_FRUITLESS:
                raise
            problem = problem_at(address, reopening_s=_REOPENING_S)
            if problem is not None:
                raise problem from None
            time.sleep(_REOPENED_PAUSE_S)  # a hub that was just opened does not answer yet


def _request_once(
    address: Address, request: JoinRequest, ask_pin: AskPin, link: Link, certificate: str
) -> Membership:
    session, is_class = open_lobby(address, link)
    with session:
        hub = certificate_identity(certificate) if certificate else dialled_identity(session)
        return _JoinQueries(session, address, hub, is_class=is_class).join(request, ask_pin)


def open_lobby(address: Address, link: Link) -> tuple[zenoh.Session, bool]:
    """Open a session at a hub as a laptop that has not joined.

    Returns:
        The session, and whether the hub has users, which only the hub of a class has.

    Raises:
        NoHubError: No hub answers at the address.
    """
    # A hub with users refuses clients without a user name. A hub without users refuses clients
    # with a user name.
    for settings in (_NOBODY, credentials(LOBBY, LOBBY_SECRET)):
        begun = time.monotonic()
        more = {**settings, **link.settings, **_OPENING}
        session = open_hub_client(link.endpoint(address), more)
        if session is not None:
            return session, settings != _NOBODY
        if time.monotonic() - begun > _SILENT_S:
            raise NoHubError(address.host, address.port, is_silent=True)
    raise NoHubError(address.host, address.port)


def is_member(joined: Membership) -> bool | None:
    """Ask a class whether this laptop is still in it. Return `None` if the class does not answer.

    Args:
        joined: This laptop's membership in the class.
    """
    try:
        session, _ = open_lobby(Address(joined.host, joined.port), Link(joined.keystore))
    except NoHubError:
        return None
    with session:
        answers = _ask_as_owner(session, joined, "member", _MEMBER_TIMEOUT_S)
    known = answers[0].get("member") if answers else None
    return known if isinstance(known, bool) else None


class _JoinQueries:
    def __init__(
        self, session: zenoh.Session, address: Address, hub: str, *, is_class: bool
    ) -> None:
        self._session = session
        self._hub = hub
        self._address = address
        self._is_class = is_class  # only the hub of a class has users

    def join(self, request: JoinRequest, ask_pin: AskPin) -> Membership:
        hello = self._greeting()
        if hello is None:
            host, port = self._address.host, self._address.port
            return Membership("partner", host, port, version=self._hub_version())
        class_name = str(hello.get("class"))
        pin = ask_pin(clean_name(class_name)) if hello.get("pin") else ""
        if pin is None:
            raise ClassroomError(
                "the class requires a PIN: run `zbot join` in a terminal, or set ZBOT_PIN"
            )
        client = PinClient(Secret(pin), class_name, self._hub)
        challenge = self._ask("enrol", client.hello())
        sealed = self._ask("claim", client.claim(challenge, asdict(request)))
        given = client.opened(sealed)
        try:
            joined = membership_from(self._address, given)
        except (KeyError, TypeError, ValueError) as exc:
            raise NoHubError(self._address.host, self._address.port) from exc
        return replace(joined, version=_version(hello))

    def _hub_version(self) -> str:
        """Return the version of zbot of a hub without a class, or `""` if it does not say it."""
        found = ask(self._session, f"{HUB_KEY}/*", timeout_s=_VERSION_TIMEOUT_S)
        return _version(found[0]) if found else ""

    def _greeting(self) -> dict[str, Any] | None:
        """Return the class's answer to `hello`, or `None` if the hub has no class."""
        # A query that ends before its timeout shows that nothing answers queries for admission.
        # The hub of a class accepts clients a short time before it answers these queries.
        for _ in range(_GREETINGS):
            begun = time.monotonic()
            found = ask(self._session, ADMISSION_KEY, {"op": "hello"}, timeout_s=_ANSWER_TIMEOUT_S)
            if found:
                return found[0]
            if self._is_class or time.monotonic() - begun > _ANSWER_TIMEOUT_S / 2:
                raise SilentHubError(self._address.host, self._address.port)
            time.sleep(_GREETING_PAUSE_S)
        return None

    def _ask(self, verb: str, question: dict[str, Any]) -> dict[str, Any]:
        question["op"] = verb
        answers = ask(self._session, ADMISSION_KEY, question, timeout_s=_ANSWER_TIMEOUT_S)
        if not answers:
            raise SilentHubError(self._address.host, self._address.port)
        return _checked(answers[0])


def _version(answer: dict[str, Any]) -> str:
    """Return the version of zbot in an answer, or `""` if the answer does not have it."""
    return single_line(str(answer.get("version", "")), _MAX_VERSION)


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
        sentence = single_line(str(answer.get("sentence")), _MAX_SENTENCE_LENGTH)
        raise RefusedError(str(kind), sentence, known, _wait_s(answer))
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


def release(joined: Membership) -> bool:
    """Release this laptop's number. Return whether the class has answered.

    If the class does not know this laptop any more, nothing has to be released.

    Args:
        joined: The membership in the class.
    """
    address = Address(joined.host, joined.port)
    if problem_at(address) is not None:
        return False
    try:
        session, _ = open_lobby(address, Link(joined.keystore))
    except NoHubError:
        return False
    with session:
        answers = _ask_as_owner(session, joined, "release", _RELEASE_TIMEOUT_S)
    return bool(answers)


def _ask_as_owner(
    session: zenoh.Session, joined: Membership, verb: str, timeout_s: float
) -> list[dict[str, Any]]:
    """Send a query to the class, with the proof that this laptop owns its number."""
    question = {"op": verb, "number": joined.number, "proof": proof(joined.claim, verb)}
    return ask(session, ADMISSION_KEY, question, timeout_s=timeout_s)
