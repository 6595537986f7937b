"""A class's PIN: how a student shows that it knows it, and gets a secret of its own for that.

Student (`PinClient`) and teacher's hub (`PinServer`) exchange four small documents over any transport,
a readable one too: neither the PIN nor what is asked for and answered can be found out from them,
and none works a second time.

    student                                  teacher
    hello   {public}                 ->
            {visit, salt, public}    <-      challenge
    claim   {visit, claim, proof}    ->
            {answer, tag}            <-      admit, seal

The key comes from SRP-6a (`zbot.security.srp`): each wrong guess costs a visit, and the door counts
those. Claim and answer are authenticated and encrypted, so nobody without the PIN can play the
teacher, or read which laptop asks.
"""

from __future__ import annotations

import hashlib
import hmac
import json
import secrets
import threading
import time
from collections import OrderedDict
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot.errors import SetupError
from zbot.security.secret import Secret
from zbot.security.srp import GROUP, ClientSide, ServerSide

if TYPE_CHECKING:
    from collections.abc import Callable

Document = dict[str, Any]

_SALT_BYTES = 16
_VISITS = 256  #: kept at a time; a class of thirty that joins at once has thirty
_VISIT_S = 30.0  #: for how long: a person has typed the PIN before the visit begins
_FREE_GUESSES = 10  #: as many students may mistype it at once
_GUESS_S = 2.0  #: after that, one guess in this time: 999,999 PINs take 23 days


class PinError(SetupError, PermissionError):
    """Root of what can go wrong with a PIN."""


class WrongPinError(PinError):
    """The PIN is not that of the class."""

    def __init__(self) -> None:
        super().__init__("wrong PIN: compare it with the one on the teacher's screen")


class TooManyGuessesError(PinError):
    """There have been so many wrong PINs that nobody is let in for a moment."""

    def __init__(self, wait_s: float) -> None:
        self.wait_s = wait_s
        super().__init__(
            f"too many wrong PINs were tried in this class: try again in {wait_s:.0f} seconds"
        )


class PinMessageError(PinError, ValueError):
    """What arrived is not what the other side of a PIN check sends."""

    def __init__(self, reason: str) -> None:
        self.reason = reason
        super().__init__(f"the PIN could not be checked ({reason}): join again")


class PinClient:
    """One attempt to get in, on the student's side.

    Args:
        pin: As it was typed.
    """

    def __init__(self, pin: Secret) -> None:
        self._pin = pin
        self._side = ClientSide()
        self._key = b""

    def hello(self) -> Document:
        """Return what to send first."""
        return {"public": f"{self._side.public:x}"}

    def claim(self, challenge: Document, wish: Document) -> Document:
        """Return what to send when the challenge has come.

        Args:
            challenge: From the door.
            wish: What is asked for, such as name and number.

        Raises:
            PinMessageError: The challenge is none.
        """
        public, salt = _public(challenge), _bytes(challenge, "salt")
        exponent = _pin_exponent(salt, self._pin)
        visit = str(challenge.get("visit"))
        self._key = _key(self._side.shared(public, exponent), self._side.public, public, visit)
        data = _mixed(self._key, "claim", json.dumps(wish).encode())
        return {"visit": visit, "claim": data.hex(), "proof": _tag(self._key, "claim", data)}

    def opened(self, sealed: Document) -> Document:
        """Return the answer that was sealed for this guest alone.

        Raises:
            PinMessageError: It is damaged, or does not come from somebody who knows the PIN.
        """
        data = _bytes(sealed, "answer")
        if not _is_tag(sealed.get("tag"), self._key, "answer", data):
            raise PinMessageError("the answer does not come from somebody who knows it")
        return _document(_mixed(self._key, "answer", data))


@dataclass(frozen=True)
class Admission:
    """A guest who has shown to know the PIN.

    Attributes:
        wish: What it asks for.
    """

    wish: Document
    _key: bytes

    def seal(self, answer: Document) -> Document:
        """Return an answer that only this guest can read; one for each admission."""
        data = _mixed(self._key, "answer", json.dumps(answer).encode())
        return {"answer": data.hex(), "tag": _tag(self._key, "answer", data)}


class PinServer:
    """The teacher's side. Safe to use from several threads.

    Args:
        pin: Of the class.
        now: A clock in seconds; tests have their own.
    """

    def __init__(self, pin: Secret, now: Callable[[], float] = time.monotonic) -> None:
        self._salt = secrets.token_bytes(_SALT_BYTES)
        self._verifier = GROUP.power(_pin_exponent(self._salt, pin))
        self._now = now
        self._lock = threading.Lock()
        self._visits: OrderedDict[str, tuple[float, int, ServerSide]] = OrderedDict()
        self._guesses = _FREE_GUESSES * 1.0
        self._counted = now()
        self.wrong = 0  #: how many wrong PINs there were

    def challenge(self, hello: Document) -> Document:
        """Return the answer to a guest's first words.

        Raises:
            PinMessageError: They make no sense.
            TooManyGuessesError: Nobody is let in now.
        """
        public = _public(hello)
        side = ServerSide(self._verifier)
        visit = secrets.token_hex(16)
        with self._lock:
            self._check_patience()
            self._visits[visit] = (self._now(), public, side)
            while len(self._visits) > _VISITS:
                self._visits.popitem(last=False)
        return {"visit": visit, "salt": self._salt.hex(), "public": f"{side.public:x}"}

    def admit(self, claim: Document) -> Admission:
        """Return who wants what, having checked that they know the PIN.

        Raises:
            WrongPinError: They do not.
            PinMessageError: The claim belongs to no visit or to one that is over, if recorded.
            TooManyGuessesError: Nobody is let in now.
        """
        visit, data = str(claim.get("visit")), _bytes(claim, "claim")
        with self._lock:
            self._check_patience()
            begun, public, side = self._visits.pop(visit, (0.0, 0, None))
            if side is None or self._now() - begun > _VISIT_S:
                raise PinMessageError("it took too long, or was tried twice")
            # Counted before it is checked, so that a hundred at once are no hundred guesses.
            self._guesses -= 1
        key = _key(side.shared(public), public, side.public, visit)
        if not _is_tag(claim.get("proof"), key, "claim", data):
            with self._lock:
                self.wrong += 1
            raise WrongPinError
        with self._lock:
            self._guesses += 1
        return Admission(_document(_mixed(key, "claim", data)), key)

    def _check_patience(self) -> None:
        now = self._now()
        self._guesses = min(_FREE_GUESSES, self._guesses + (now - self._counted) / _GUESS_S)
        self._counted = now
        if self._guesses < 1:
            raise TooManyGuessesError((1 - self._guesses) * _GUESS_S)


def random_pin() -> Secret:
    """Return a PIN of six digits."""
    return Secret(f"{secrets.randbelow(1_000_000):06d}")


def _pin_exponent(salt: bytes, pin: Secret) -> int:
    return GROUP.password_exponent(salt, b"zbot class", pin.reveal().strip().encode())


def _key(shared: int, guest: int, door: int, visit: str) -> bytes:
    numbers = b"".join(GROUP.padded(number) for number in (shared, guest, door))
    return hashlib.sha256(numbers + visit.encode()).digest()


def _tag(key: bytes, purpose: str, data: bytes) -> str:
    return hmac.new(key, f"{purpose}:".encode() + data, "sha256").hexdigest()


def _is_tag(found: object, key: bytes, purpose: str, data: bytes) -> bool:
    return hmac.compare_digest(_tag(key, purpose, data).encode(), _encoded(found))


def _encoded(found: object) -> bytes:
    # JSON may hold halves of characters, which UTF-8 does not.
    return str(found).encode(errors="backslashreplace")


def _mixed(key: bytes, purpose: str, data: bytes) -> bytes:
    """Encrypt or decrypt: HMAC in counter mode; a key serves for one claim and one answer only."""
    blocks = (f"{purpose} {number}".encode() for number in range((len(data) + 31) // 32))
    stream = b"".join(hmac.digest(key, block, "sha256") for block in blocks)
    return bytes(one ^ other for one, other in zip(data, stream, strict=False))


def _public(document: Document) -> int:
    text = document.get("public")
    longest = GROUP.prime.bit_length() // 4
    try:
        number = int(text, 16) if isinstance(text, str) and len(text) <= longest else 0
    except ValueError:
        number = 0
    if not GROUP.is_public(number):
        raise PinMessageError("no valid public number")
    return number


def _bytes(document: Document, name: str) -> bytes:
    try:
        return bytes.fromhex(str(document.get(name)))
    except ValueError:
        raise PinMessageError(f"no valid {name}") from None


def _document(data: bytes) -> Document:
    try:
        found = json.loads(data)
    except (ValueError, RecursionError):
        found = None
    if not isinstance(found, dict):
        raise PinMessageError("no valid document")
    return found
