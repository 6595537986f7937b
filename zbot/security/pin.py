"""PIN check of a class. A laptop proves that it knows the PIN, and gets a secret of its own.

The student's laptop (`PinClient`) and the teacher's hub (`PinServer`) exchange four documents. The
documents do not need an encrypted connection, because nobody else can read the PIN, the request or
the answer in them. If somebody records a document and sends it again, the hub refuses it.

    student                                  teacher
    hello   {protocol, hub, public}  ->
            {protocol, visit, public} <-     challenge
    claim   {visit, claim, proof}    ->
            {answer, tag}            <-      admit, seal

The keys come from SPAKE2 (`zbot.security.key_exchange`). Each guess of the PIN needs a new attempt
(`visit`), and the server counts wrong PINs. `proof` and `tag` show that both sides have the same
keys. So a program that does not know the PIN cannot impersonate the teacher or read which laptop
sends a claim.

The keys also depend on `hub`, the address or certificate to which the laptop has connected. The
class refuses a `hub` that is not its own. So a program at another address that forwards the
documents cannot admit a laptop. docs/design/pin-exchange.md gives the reasons.
"""

from __future__ import annotations

import contextlib
import json
import secrets
import threading
import time
from collections import OrderedDict
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from zbot.errors import SetupError
from zbot.security.key_exchange import (
    PROOF_BYTES,
    PUBLIC_BYTES,
    SEAL_BYTES,
    ExchangeError,
    KeyExchange,
    Keys,
    WrongProofError,
    exchange_s,
)
from zbot.security.secret import Secret
from zbot.text.json_reader import JsonError, read_json_object

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

Document = dict[str, Any]

#: Version of the documents. Version 1 used SRP, and its documents have no field `protocol`.
PROTOCOL = 2

_VISIT_BYTES = 16
_LARGEST_TEXT = 24 * 1024  #: bytes of a request or an answer (a valid one has a few hundred bytes)
#: Number of bytes of each field. Each byte is two hexadecimal digits in lower case.
_SIZES = {
    "visit": range(_VISIT_BYTES, _VISIT_BYTES + 1),
    "public": range(PUBLIC_BYTES, PUBLIC_BYTES + 1),
    "proof": range(PROOF_BYTES, PROOF_BYTES + 1),
    "tag": range(PROOF_BYTES, PROOF_BYTES + 1),
    "claim": range(SEAL_BYTES, SEAL_BYTES + _LARGEST_TEXT + 1),
    "answer": range(SEAL_BYTES, SEAL_BYTES + _LARGEST_TEXT + 1),
}
_LONGEST_HUB = 300  #: characters (a host name has at most 253)
_MAX_ATTEMPTS = 256  #: open attempts (thirty students who join together need thirty attempts)
_ATTEMPT_S = 30.0  #: longest time of an attempt (the student types the PIN before it begins)
_FREE_GUESSES = 10  #: wrong PINs without a delay, because several students may mistype at a time
_GUESS_S = 2.0  #: seconds between further wrong PINs (999,999 PINs take 23 days)


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


def pin_version_error(laptop: int, of_class: int) -> PinError:
    """Return the error that the laptop and the class use different versions of the PIN check."""
    return PinError(
        "zbot on this laptop is older than zbot of the class: install the newer zbot on this laptop"
        if laptop < of_class
        else "zbot of the class is older than zbot on this laptop: ask the teacher to "
        "install the newer zbot"
    )


class PinClient:
    """Student's side of one PIN check.

    Args:
        pin: The PIN as it was typed.
        class_name: The class's name, as the hub gave it.
        hub: The address or certificate of the hub to which this laptop has connected.
    """

    def __init__(self, pin: Secret, class_name: str, hub: str) -> None:
        self._hub = hub
        self._side = KeyExchange("laptop", _password(pin), _identity(class_name, hub))
        self._keys: Keys | None = None

    def hello(self) -> Document:
        """Return the first document to send."""
        return {"protocol": PROTOCOL, "hub": self._hub, "public": self._side.public.hex()}

    def claim(self, challenge: Document, request: Document) -> Document:
        """Return the second document to send. Call this once.

        Args:
            challenge: The server's reply to `hello`.
            request: The document to send encrypted, such as name and number.

        Raises:
            PinMessageError: The challenge is invalid.
            PinError: The class has another version of the PIN check.
        """
        found = _protocol(challenge)
        if found != PROTOCOL:
            raise pin_version_error(PROTOCOL, found)
        attempt = _bytes(challenge, "visit").hex()
        self._keys = _keys(self._side, _bytes(challenge, "public"), attempt)
        return {"visit": attempt, **_Sealed.make(request, "claim", self._keys).message()}

    def opened(self, sealed: Document) -> Document:
        """Return the decrypted answer.

        Raises:
            PinMessageError: The answer is damaged, or its sender does not know the PIN.
        """
        if self._keys is None:
            raise PinMessageError("an answer came before the claim")
        try:
            return _Sealed.of(sealed, "answer").opened(self._keys)
        except WrongProofError:
            raise PinMessageError("the sender of the answer does not know it") from None


@dataclass(frozen=True)
class Admission:
    """Admission of a client that has proved that it knows the PIN.

    Attributes:
        request: The client's request.
    """

    request: Document
    _keys: Keys = field(repr=False)

    def seal(self, answer: Document) -> Document:
        """Return an answer that only this client can read."""
        return _Sealed.make(answer, "answer", self._keys).message()


class PinServer:
    """Teacher's side of PIN checks. Safe to use from several threads.

    Args:
        pin: The PIN of the class.
        class_name: The class's name.
        is_own_hub: Returns whether an address or certificate is that of the class's hub.
        now: A monotonic clock in seconds. Tests replace it.
        sleep: Waits for some seconds. Tests replace it.
    """

    def __init__(
        self,
        pin: Secret,
        class_name: str,
        is_own_hub: Callable[[str], bool],
        now: Callable[[], float] = time.monotonic,
        sleep: Callable[[float], None] = time.sleep,
    ) -> None:
        self._password = _password(pin)
        self._class_name = class_name
        self._is_own_hub = is_own_hub
        self._now = now
        self._sleep = sleep
        self._lock = threading.Lock()
        self._attempts: OrderedDict[str, tuple[float, bytes, KeyExchange]] = OrderedDict()
        self._guesses = _FREE_GUESSES * 1.0
        self._counted = now()
        self.wrong = 0  #: number of wrong PINs

    def challenge(self, hello: Document) -> Document:
        """Return the reply to a client's `hello`.

        Raises:
            PinMessageError: The document is invalid.
            PinError: The laptop has another version of the PIN check, or the laptop has connected
                to a hub that is not the class's.
            TooManyGuessesError: Too many PINs were wrong.
        """
        found = _protocol(hello)
        if found != PROTOCOL:
            raise pin_version_error(found, PROTOCOL)
        public, hub = _bytes(hello, "public"), _hub(hello)
        if not self._is_own_hub(hub):
            raise PinError(
                "this laptop did not dial the class's own machine, but one that forwards to it: "
                "use the code or address on the teacher's screen (if the teacher's machine is "
                "behind a router or is a virtual machine, the class needs a keystore)"
            )
        with self._lock:
            self._check_guess_rate()
        with self._steady_time():
            side = KeyExchange("class", self._password, _identity(self._class_name, hub))
        attempt = secrets.token_hex(_VISIT_BYTES)
        with self._lock:
            self._attempts[attempt] = (self._now(), public, side)
            while len(self._attempts) > _MAX_ATTEMPTS:
                self._attempts.popitem(last=False)
        return {"protocol": PROTOCOL, "visit": attempt, "public": side.public.hex()}

    def admit(self, claim: Document) -> Admission:
        """Check that the client knows the PIN, and return its admission.

        Raises:
            WrongPinError: The client does not know the PIN.
            PinMessageError: The claim is damaged. Or its attempt does not exist, has expired, or
                was used before.
            TooManyGuessesError: Too many PINs were wrong.
        """
        attempt, sealed = _bytes(claim, "visit").hex(), _Sealed.of(claim, "claim")
        with self._lock:
            self._check_guess_rate()
            begun, public, side = self._attempts.pop(attempt, (0.0, b"", None))
            if side is None or self._now() - begun > _ATTEMPT_S:
                raise PinMessageError("the attempt took too long, or was tried twice")
            # The guess is counted before the check, so simultaneous claims cannot exceed the limit.
            self._guesses -= 1
        with self._steady_time():
            keys = _keys(side, public, attempt)
        try:
            request = sealed.opened(keys)
        except WrongProofError:
            with self._lock:
                self.wrong += 1
            raise WrongPinError from None
        with self._lock:
            self._guesses += 1
        return Admission(request, keys)

    @contextlib.contextmanager
    def _steady_time(self) -> Iterator[None]:
        """Let a `with` block always take the same time.

        The time of a computation with the PIN depends on the PIN. Without this, an attacker could
        measure the time often, and find out the PIN.
        """
        end = time.perf_counter() + exchange_s()
        try:
            yield
        finally:
            self._sleep(max(0.0, end - time.perf_counter()))

    def _check_guess_rate(self) -> None:
        now = self._now()
        self._guesses = min(_FREE_GUESSES, self._guesses + (now - self._counted) / _GUESS_S)
        self._counted = now
        if self._guesses < 1:
            raise TooManyGuessesError((1 - self._guesses) * _GUESS_S)


def random_pin() -> Secret:
    """Return a PIN of six digits."""
    return Secret(f"{secrets.randbelow(1_000_000):06d}")


def _password(pin: Secret) -> bytes:
    # Text from the environment may contain surrogate characters, which UTF-8 cannot encode.
    return pin.reveal().strip().encode(errors="backslashreplace")


def _identity(class_name: str, hub: str) -> bytes:
    return json.dumps([class_name, hub]).encode()


def _keys(side: KeyExchange, public: bytes, attempt: str) -> Keys:
    try:
        return side.keys(public, ["zbot class", PROTOCOL, attempt])
    except ExchangeError:
        raise PinMessageError("no valid public") from None


_PROOFS = {"claim": "proof", "answer": "tag"}  #: proof field of each sealed field


@dataclass(frozen=True)
class _Sealed:
    """Sealed document and the proof of its sender."""

    field: str
    proof: bytes
    data: bytes

    @classmethod
    def make(cls, document: Document, field: str, keys: Keys) -> _Sealed:
        text = json.dumps(document).encode()
        if len(text) > _LARGEST_TEXT:
            raise PinMessageError(f"the {field} is too long")
        return cls(field, keys.proof(field), keys.seal(field, text))

    @classmethod
    def of(cls, message: Document, field: str) -> _Sealed:
        return cls(field, _bytes(message, _PROOFS[field]), _bytes(message, field))

    def message(self) -> Document:
        return {self.field: self.data.hex(), _PROOFS[self.field]: self.proof.hex()}

    def opened(self, keys: Keys) -> Document:
        """Check the proof and the seal, and return the document.

        Raises:
            WrongProofError: The sender does not know the PIN.
            PinMessageError: The document is damaged.
        """
        try:
            return _document(keys.opened(self.field, self.proof, self.data))
        except WrongProofError:
            raise
        except ExchangeError:
            raise PinMessageError(f"no valid {self.field}") from None


def _protocol(document: Document) -> int:
    found = document.get("protocol", 1 if "public" in document else None)
    if type(found) is not int or found < 1:  # `True` is an `int` too
        raise PinMessageError("no valid protocol")
    return found


def _hub(document: Document) -> str:
    hub = document.get("hub")
    if not isinstance(hub, str) or not 0 < len(hub) <= _LONGEST_HUB:
        raise PinMessageError("no valid hub")
    return hub


def _bytes(document: Document, name: str) -> bytes:
    """Return the bytes of a field. Each value has exactly one valid text."""
    text, sizes = document.get(name), _SIZES[name]
    if isinstance(text, str) and len(text) // 2 in sizes:
        try:
            data = bytes.fromhex(text)
        except ValueError:
            data = b""
        if data.hex() == text:
            return data
    raise PinMessageError(f"no valid {name}")


def _document(data: bytes) -> Document:
    try:
        return read_json_object(data)
    except JsonError:
        raise PinMessageError("no valid document") from None
