"""PIN check of a class: a laptop proves that it knows the PIN, and gets a secret of its own.

The student's laptop (`PinClient`) and the teacher's hub (`PinServer`) exchange four documents. The
transport may be unencrypted, because nobody can read the PIN, the request or the answer in the
documents. If somebody records a document and sends it again, it is refused.

    student                                  teacher
    hello   {public}                 ->
            {visit, salt, public}    <-      challenge
    claim   {visit, claim, proof}    ->
            {answer, tag}            <-      admit, seal

The key comes from SRP-6a (`zbot.security.srp`). Each guess of the PIN needs an attempt of its own,
and the server counts wrong PINs. Claim and answer are authenticated and encrypted. So a program
that does not know the PIN cannot impersonate the teacher or read which laptop sends a claim.
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
_MAX_ATTEMPTS = 256  #: open attempts (thirty students who join at once need thirty attempts)
_ATTEMPT_S = 30.0  #: seconds for an attempt (the student types the PIN before the attempt)
_FREE_GUESSES = 10  #: wrong PINs without a delay, because several students may mistype at once
_GUESS_S = 2.0  #: seconds for each wrong PIN after that (999,999 PINs take 23 days)


class PinError(SetupError, PermissionError):
    """Root of the errors of a PIN check."""


class WrongPinError(PinError):
    """The PIN is not the PIN of the class."""

    def __init__(self) -> None:
        super().__init__("wrong PIN: compare it with the one on the teacher's screen")


class TooManyGuessesError(PinError):
    """The class refuses all PINs for a moment, because too many PINs were wrong."""

    def __init__(self, wait_s: float) -> None:
        self.wait_s = wait_s
        super().__init__(
            f"too many wrong PINs were tried in this class: try again in {wait_s:.0f} seconds"
        )


class PinMessageError(PinError, ValueError):
    """A document is not a valid message of a PIN check."""

    def __init__(self, reason: str) -> None:
        self.reason = reason
        super().__init__(f"the PIN could not be checked ({reason}): join again")


class PinClient:
    """Student's side of one PIN check.

    Args:
        pin: The PIN as it was typed.
    """

    def __init__(self, pin: Secret) -> None:
        self._pin = pin
        self._side = ClientSide()
        self._key = b""

    def hello(self) -> Document:
        """Return the first document to send."""
        return {"public": f"{self._side.public:x}"}

    def claim(self, challenge: Document, request: Document) -> Document:
        """Return the second document to send.

        Args:
            challenge: The server's reply to `hello`.
            request: The document to send encrypted, such as name and number.

        Raises:
            PinMessageError: The challenge is invalid.
        """
        public, salt = _public(challenge), _bytes(challenge, "salt")
        exponent = _pin_exponent(salt, self._pin)
        attempt = str(challenge.get("visit"))
        self._key = _key(self._side.shared(public, exponent), self._side.public, public, attempt)
        data = _mixed(self._key, "claim", json.dumps(request).encode())
        return {"visit": attempt, "claim": data.hex(), "proof": _tag(self._key, "claim", data)}

    def opened(self, sealed: Document) -> Document:
        """Return the decrypted answer.

        Raises:
            PinMessageError: The answer is damaged, or its sender does not know the PIN.
        """
        data = _bytes(sealed, "answer")
        if not _is_tag(sealed.get("tag"), self._key, "answer", data):
            raise PinMessageError("the sender of the answer does not know it")
        return _document(_mixed(self._key, "answer", data))


@dataclass(frozen=True)
class Admission:
    """Admission of a client that has proved that it knows the PIN.

    Attributes:
        request: The client's request.
    """

    request: Document
    _key: bytes

    def seal(self, answer: Document) -> Document:
        """Return an answer that only this client can read. Call this once for each admission."""
        data = _mixed(self._key, "answer", json.dumps(answer).encode())
        return {"answer": data.hex(), "tag": _tag(self._key, "answer", data)}


class PinServer:
    """Teacher's side of PIN checks. Safe to use from several threads.

    Args:
        pin: The PIN of the class.
        now: A monotonic clock in seconds. Tests replace it.
    """

    def __init__(self, pin: Secret, now: Callable[[], float] = time.monotonic) -> None:
        self._salt = secrets.token_bytes(_SALT_BYTES)
        self._verifier = GROUP.power(_pin_exponent(self._salt, pin))
        self._now = now
        self._lock = threading.Lock()
        self._attempts: OrderedDict[str, tuple[float, int, ServerSide]] = OrderedDict()
        self._guesses = _FREE_GUESSES * 1.0
        self._counted = now()
        self.wrong = 0  #: number of wrong PINs

    def challenge(self, hello: Document) -> Document:
        """Return the reply to a client's `hello`.

        Raises:
            PinMessageError: The document is invalid.
            TooManyGuessesError: Too many PINs were wrong.
        """
        public = _public(hello)
        side = ServerSide(self._verifier)
        attempt = secrets.token_hex(16)
        with self._lock:
            self._check_guess_rate()
            self._attempts[attempt] = (self._now(), public, side)
            while len(self._attempts) > _MAX_ATTEMPTS:
                self._attempts.popitem(last=False)
        return {"visit": attempt, "salt": self._salt.hex(), "public": f"{side.public:x}"}

    def admit(self, claim: Document) -> Admission:
        """Check that the client knows the PIN, and return its admission.

        Raises:
            WrongPinError: The client does not know the PIN.
            PinMessageError: The claim's attempt does not exist, has expired or was used before.
            TooManyGuessesError: Too many PINs were wrong.
        """
        attempt, data = str(claim.get("visit")), _bytes(claim, "claim")
        with self._lock:
            self._check_guess_rate()
            begun, public, side = self._attempts.pop(attempt, (0.0, 0, None))
            if side is None or self._now() - begun > _ATTEMPT_S:
                raise PinMessageError("the attempt took too long, or was tried twice")
            # The guess is counted before the check, so simultaneous claims cannot exceed the limit.
            self._guesses -= 1
        key = _key(side.shared(public), public, side.public, attempt)
        if not _is_tag(claim.get("proof"), key, "claim", data):
            with self._lock:
                self.wrong += 1
            raise WrongPinError
        with self._lock:
            self._guesses += 1
        return Admission(_document(_mixed(key, "claim", data)), key)

    def _check_guess_rate(self) -> None:
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


def _key(shared: int, client: int, server: int, attempt: str) -> bytes:
    numbers = b"".join(GROUP.padded(number) for number in (shared, client, server))
    return hashlib.sha256(numbers + attempt.encode()).digest()


def _tag(key: bytes, purpose: str, data: bytes) -> str:
    return hmac.new(key, f"{purpose}:".encode() + data, "sha256").hexdigest()


def _is_tag(found: object, key: bytes, purpose: str, data: bytes) -> bool:
    return hmac.compare_digest(_tag(key, purpose, data).encode(), _encoded(found))


def _encoded(found: object) -> bytes:
    # JSON may contain single surrogates. UTF-8 cannot encode them.
    return str(found).encode(errors="backslashreplace")


def _mixed(key: bytes, purpose: str, data: bytes) -> bytes:
    """Encrypt or decrypt with HMAC in counter mode. A key serves one claim and one answer."""
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
