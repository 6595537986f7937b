"""SPAKE2: two sides that know the same short password agree on long keys.

Somebody who records the messages cannot use them to test passwords. An attacker who pretends to be
one side can test one password in each exchange, and the other side notices a wrong password. The
package `spake2` computes the exchange. The package `cryptography` derives keys from the result and
seals documents, so that nobody else can read or change them. This module does not send or store
anything.
"""

from __future__ import annotations

import functools
import hmac
import json
import secrets
import time
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal

PUBLIC_BYTES = 33  #: one byte for the side, and a point of Curve25519
PROOF_BYTES = 32
SEAL_BYTES = 28  #: a nonce and a tag, which a sealed text has in addition to the text

_MEASUREMENTS = 3
_LONGEST_S = 0.1  #: the limit for `exchange_s`, because a busy machine measures too much
_KEY_BYTES = 32
_NONCE_BYTES = 12
_LAPTOP = b"laptop"

if TYPE_CHECKING:
    from cryptography.hazmat.primitives.ciphers.aead import ChaCha20Poly1305

Side = Literal["laptop", "class"]


class ExchangeError(ValueError):
    """A message of the other side is damaged, or belongs to another exchange."""


class WrongProofError(ExchangeError):
    """The other side has other keys, because it used another password or another identity."""


class KeyExchange:
    """One side of one exchange.

    Args:
        side: The side that this object plays.
        password: The short password.
        identity: Identity of the class. The keys differ if the two sides use different identities.
    """

    def __init__(self, side: Side, password: bytes, identity: bytes) -> None:
        # The import takes 40 ms, and most programs exchange no keys.
        from spake2 import SPAKE2_A, SPAKE2_B  # noqa: PLC0415

        self._spake2 = (SPAKE2_A if side == "laptop" else SPAKE2_B)(password, _LAPTOP, identity)
        self.public: bytes = self._spake2.start()  #: to send to the other side

    def keys(self, public: bytes, context: list[Any]) -> Keys:
        """Return the keys that both sides get if password, identity and context are the same.

        Call this only once for each object.

        Args:
            public: The other side's message.
            context: Values that both sides know. JSON must be able to store them.

        Raises:
            ExchangeError: The message is not from the other side, or it is not a valid point.
        """
        from spake2 import SPAKEError  # noqa: PLC0415
        from spake2.ed25519_basic import NotOnCurve  # noqa: PLC0415

        if len(public) != PUBLIC_BYTES:
            raise ExchangeError("a public number has another length")
        try:
            shared = self._spake2.finish(public)
        except (SPAKEError, NotOnCurve, ValueError) as exc:
            raise ExchangeError("a public number is not valid") from exc
        return Keys(shared, context)


@functools.cache
def exchange_s() -> float:
    """Return how many seconds one side of an exchange takes on this machine, at most 0.1."""
    took = []
    for _ in range(_MEASUREMENTS):
        other = KeyExchange("laptop", secrets.token_bytes(_KEY_BYTES), b"")
        begun = time.perf_counter()
        KeyExchange("class", secrets.token_bytes(_KEY_BYTES), b"").keys(other.public, [])
        took.append(time.perf_counter() - begun)
    return min(max(took), _LONGEST_S)


@dataclass(frozen=True)
class Keys:
    """Keys of one exchange. Each purpose (name of a message) has its own proof and its own key."""

    _shared: bytes = field(repr=False)
    _context: list[Any]

    def proof(self, purpose: str) -> bytes:
        """Return the bytes that prove to the other side that this side has the same keys."""
        return self._derived(f"{purpose} proof", PROOF_BYTES)

    def seal(self, purpose: str, text: bytes) -> bytes:
        """Return a text that only the other side can read and nobody can change."""
        nonce = secrets.token_bytes(_NONCE_BYTES)
        return nonce + self._cipher(purpose).encrypt(nonce, text, None)

    def opened(self, purpose: str, proof: bytes, sealed: bytes) -> bytes:
        """Return the text that the other side has sealed.

        Raises:
            ExchangeError: The text was changed, or it was sealed for another purpose.
            WrongProofError: The other side has other keys, so it does not know the password.
        """
        from cryptography.exceptions import InvalidTag  # noqa: PLC0415

        if not hmac.compare_digest(self.proof(purpose), proof):
            raise WrongProofError("the other side has other keys")
        nonce, data = sealed[:_NONCE_BYTES], sealed[_NONCE_BYTES:]
        try:
            return self._cipher(purpose).decrypt(nonce, data, None)
        except (InvalidTag, ValueError) as exc:
            raise ExchangeError("a sealed text was changed") from exc

    def _cipher(self, purpose: str) -> ChaCha20Poly1305:
        from cryptography.hazmat.primitives.ciphers import aead  # noqa: PLC0415

        return aead.ChaCha20Poly1305(self._derived(f"{purpose} key", _KEY_BYTES))

    def _derived(self, purpose: str, length: int) -> bytes:
        from cryptography.hazmat.primitives.hashes import SHA256  # noqa: PLC0415
        from cryptography.hazmat.primitives.kdf.hkdf import HKDF  # noqa: PLC0415

        info = json.dumps([*self._context, purpose]).encode()
        return HKDF(SHA256(), length, None, info).derive(self._shared)
