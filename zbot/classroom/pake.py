"""Proving that one knows the PIN without sending it: SRP-6a (RFC 2945, RFC 5054), with SHA-256.

A PIN is short. Whoever listens to this exchange cannot try PINs on what was heard, and whoever only
pretends to be the class learns nothing to try them on: each guess costs one visit to the teacher's
hub, which slows them down. Both sides end with a secret key of their own that nobody else has. A
class without a PIN uses the empty one, and has at least the key.
"""

from __future__ import annotations

import hashlib
import hmac
import json
import secrets
from dataclasses import dataclass
from typing import Any

# The 2048-bit group of RFC 5054, appendix A; its generator is 2.
_PRIME = int(
    "AC6BDB41324A9A9BF166DE5E1389582FAF72B6651987EE07FC3192943DB56050A37329CBB4A099ED8193E0757767A1"
    "3DD52312AB4B03310DCD7F48A9DA04FD50E8083969EDB767B0CF6095179A163AB3661A05FBD5FAAAE82918A9962F0B"
    "93B855F97993EC975EEAA80D740ADBF4FF747359D041D5C33EA71D281E446B14773BCA97B43A23FB801676BD207A43"
    "6C6481F1D2B9078717461A5B9D32E688F87748544523B524B0D57D5EA77A2775D2ECFA032CFBDBF52FB37861602790"
    "04E57AE6AF874E7303CE53299CCC041C7BC308D82A5698F3A8D0C38271AE35F8E9DBFBB694B5C803D89F7AE435DE23"
    "6D525F54759B65E372FCD68EF20FA7111F9E4AFF73",
    16,
)
_GENERATOR = 2
_WIDTH = 256  # bytes of a group element
_EXPONENT_BITS = 256
_SALT_BYTES = 16
_ROUNDS = 20_000  # of PBKDF2: 10 ms for each student, and for each guess at a stolen verifier


class ProofError(ValueError):
    """A number or a proof is not what somebody with the right PIN would have sent."""


def _hash(*parts: bytes) -> bytes:
    return hashlib.sha256(b"".join(parts)).digest()


def _bytes(number: int) -> bytes:
    return number.to_bytes(_WIDTH, "big")


def _int(data: bytes) -> int:
    return int.from_bytes(data, "big")


_MULTIPLIER = _int(_hash(_bytes(_PRIME), _bytes(_GENERATOR)))


def _exponent(pin: str, salt: bytes) -> int:
    return _int(hashlib.pbkdf2_hmac("sha256", pin.encode(), salt, _ROUNDS))


def _scramble(mine: int, theirs: int) -> int:
    return _int(_hash(_bytes(mine), _bytes(theirs)))


def _element(text: object) -> int:
    """Read what the other side sent; a multiple of the prime would fix the key."""
    try:
        number = int(str(text)[: 2 * _WIDTH], 16)
    except ValueError as exc:
        raise ProofError("no number of the group") from exc
    if number % _PRIME == 0:
        raise ProofError("a number that no honest partner sends")
    return number % _PRIME


@dataclass(frozen=True)
class Verifier:
    """What the teacher's side keeps of a PIN."""

    salt: bytes
    value: int

    @classmethod
    def of(cls, pin: str) -> Verifier:
        """Return a new verifier."""
        salt = secrets.token_bytes(_SALT_BYTES)
        return cls(salt, pow(_GENERATOR, _exponent(pin, salt), _PRIME))


class StudentSide:
    """Whoever has to prove the PIN."""

    def __init__(self) -> None:
        self._secret = secrets.randbits(_EXPONENT_BITS)
        self._public = pow(_GENERATOR, self._secret, _PRIME)

    @property
    def public(self) -> str:
        """What to send first."""
        return f"{self._public:x}"

    def key(self, pin: str, salt: bytes, theirs: object) -> bytes:
        """Return the key, having got the other side's salt and public number.

        Raises:
            ProofError: The number is none.
        """
        other, exponent = _element(theirs), _exponent(pin, salt)
        scramble = _scramble(self._public, other)
        base = (other - _MULTIPLIER * pow(_GENERATOR, exponent, _PRIME)) % _PRIME
        return _hash(_bytes(pow(base, self._secret + scramble * exponent, _PRIME)))


class TeacherSide:
    """Whoever checks it.

    Args:
        verifier: Of the right PIN.
        theirs: The student's public number, as it came.

    Raises:
        ProofError: The number is none.
    """

    def __init__(self, verifier: Verifier, theirs: object) -> None:
        other = _element(theirs)
        secret = secrets.randbits(_EXPONENT_BITS)
        power = pow(_GENERATOR, secret, _PRIME)
        public = (_MULTIPLIER * verifier.value + power) % _PRIME
        base = other * pow(verifier.value, _scramble(other, public), _PRIME) % _PRIME
        self.public = f"{public:x}"
        self.key = _hash(_bytes(pow(base, secret, _PRIME)))


def proof(key: bytes, *facts: Any) -> str:
    """Return what shows that its sender has the key and means these facts."""
    text = json.dumps(facts, sort_keys=True, separators=(",", ":"))
    return hmac.new(_hash(key, b"proof"), text.encode(), hashlib.sha256).hexdigest()


def is_proof(key: bytes, given: object, *facts: Any) -> bool:
    """Return whether a proof is right, in a time that tells nothing about it."""
    return hmac.compare_digest(proof(key, *facts).encode(), str(given).encode())


def seal(key: bytes, document: dict[str, Any]) -> dict[str, str]:
    """Hide a document from all but the owner of the key; a key seals one document only."""
    plain = json.dumps(document).encode()
    hidden = _mask(key, plain)
    return {"hidden": hidden.hex(), "mark": _mark(key, hidden)}


def unseal(key: bytes, sealed: dict[str, Any]) -> dict[str, Any]:
    """Return what was sealed with this key.

    Raises:
        ProofError: It was sealed with another, or changed on the way.
    """
    try:
        hidden = bytes.fromhex(str(sealed["hidden"]))
        marked = str(sealed["mark"])
    except (KeyError, ValueError) as exc:
        raise ProofError("nothing sealed") from exc
    if not hmac.compare_digest(_mark(key, hidden).encode(), marked.encode()):
        raise ProofError("sealed with another key")
    found: dict[str, Any] = json.loads(_mask(key, hidden))
    return found


def _mark(key: bytes, hidden: bytes) -> str:
    return hmac.new(_hash(key, b"mark"), hidden, hashlib.sha256).hexdigest()


def _mask(key: bytes, data: bytes) -> bytes:
    # SHAKE-256 of a key that is used once is a one-time pad.
    stream = hashlib.shake_256(_hash(key, b"hide")).digest(len(data))
    return bytes(left ^ right for left, right in zip(data, stream, strict=True))
