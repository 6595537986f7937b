"""SRP-6a (RFC 5054): two sides agree on a long key if they know the same short password.

An eavesdropper cannot test passwords offline with the messages. An attacker who takes the place of
one side can test one password in each exchange, and the other side notices this. The module only
computes. It sends and stores nothing.
"""

from __future__ import annotations

import hashlib
import secrets
from dataclasses import dataclass

_EXPONENT_BITS = 256  #: twice the security level of the 3072-bit group


@dataclass(frozen=True)
class Group:
    """Prime, generator and hash function that both sides use.

    Attributes:
        prime: A safe prime, `N` in the RFC.
        generator: `g` in the RFC.
        hash_name: The hash function's name in `hashlib.new`.
    """

    prime: int
    generator: int
    hash_name: str = "sha256"

    def digest(self, *parts: bytes) -> bytes:
        """Return the hash of the concatenated parts."""
        return hashlib.new(self.hash_name, b"".join(parts)).digest()

    def padded(self, number: int) -> bytes:
        """Return a number as bytes, padded to the length of the prime."""
        return number.to_bytes((self.prime.bit_length() + 7) // 8, "big")

    def power(self, exponent: int) -> int:
        """Return the generator to the power of the exponent, modulo the prime."""
        return pow(self.generator, exponent, self.prime)

    def multiplier(self) -> int:
        """Return `k` in the RFC."""
        return _number(self.digest(self.padded(self.prime), self.padded(self.generator)))

    def scrambler(self, client_public: int, server_public: int) -> int:
        """Return `u` in the RFC."""
        return _number(self.digest(self.padded(client_public), self.padded(server_public)))

    def password_exponent(self, salt: bytes, name: bytes, password: bytes) -> int:
        """Return `x` in the RFC, the exponent that is derived from the password."""
        return _number(self.digest(salt, self.digest(name, b":", password)))

    def is_public(self, number: int) -> bool:
        """Return whether a public number is valid. Invalid numbers would reveal the key."""
        return 0 < number < self.prime


#: RFC 5054's 3072-bit group, whose prime is RFC 3526's:
#: 2^3072 - 2^3008 - 1 + 2^64 * (floor(2^2942 * pi) + 1690314).
GROUP = Group(
    prime=int(
        "FFFFFFFFFFFFFFFFC90FDAA22168C234C4C6628B80DC1CD129024E088A67CC74"
        "020BBEA63B139B22514A08798E3404DDEF9519B3CD3A431B302B0A6DF25F1437"
        "4FE1356D6D51C245E485B576625E7EC6F44C42E9A637ED6B0BFF5CB6F406B7ED"
        "EE386BFB5A899FA5AE9F24117C4B1FE649286651ECE45B3DC2007CB8A163BF05"
        "98DA48361C55D39A69163FA8FD24CF5F83655D23DCA3AD961C62F356208552BB"
        "9ED529077096966D670C354E4ABC9804F1746C08CA18217C32905E462E36CE3B"
        "E39E772C180E86039B2783A2EC07A28FB5C55DF06F4C52C9DE2BCBF695581718"
        "3995497CEA956AE515D2261898FA051015728E5A8AAAC42DAD33170D04507A33"
        "A85521ABDF1CBA64ECFB850458DBEF0A8AEA71575D060C7DB3970F85A6E1E4C7"
        "ABF5AE8CDB0933D71E8C94E04A25619DCEE3D2261AD2EE6BF12FFA06D98A0864"
        "D87602733EC86A64521F2B18177B200CBBE117577A615D6C770988C0BAD946E2"
        "08E24FA074E5AB3143DB5BFCE0FD108E4B82D120A93AD2CAFFFFFFFFFFFFFFFF",
        16,
    ),
    generator=5,
)


def random_exponent() -> int:
    """Return a new secret exponent."""
    return secrets.randbits(_EXPONENT_BITS) | 1 << (_EXPONENT_BITS - 1)


class ClientSide:
    """Client's side, which knows the password.

    Args:
        group: The same group as the server's.
        exponent: A secret number that is used once. It is random if left out. Only tests give it.
    """

    def __init__(self, group: Group = GROUP, exponent: int | None = None) -> None:
        self._group = group
        self._exponent = exponent if exponent is not None else random_exponent()
        self.public = group.power(self._exponent)

    def shared(self, server_public: int, password_exponent: int) -> int:
        """Return the secret number. The server gets the same number if it knows the verifier."""
        group = self._group
        scrambler = group.scrambler(self.public, server_public)
        base = server_public - group.multiplier() * group.power(password_exponent)
        return pow(base, self._exponent + scrambler * password_exponent, group.prime)


class ServerSide:
    """Server's side, which knows the verifier. The verifier is the generator to the power of `x`.

    Args:
        verifier: `v` in the RFC.
        group: The same group as the client's.
        exponent: A secret number that is used once. It is random if left out. Only tests give it.
    """

    def __init__(self, verifier: int, group: Group = GROUP, exponent: int | None = None) -> None:
        self._group, self._verifier = group, verifier
        self._exponent = exponent if exponent is not None else random_exponent()
        self.public = (group.multiplier() * verifier + group.power(self._exponent)) % group.prime

    def shared(self, client_public: int) -> int:
        """Return the secret number. The client gets the same number if it knows the password."""
        group = self._group
        scrambler = group.scrambler(client_public, self.public)
        base = client_public * pow(self._verifier, scrambler, group.prime)
        return pow(base, self._exponent, group.prime)


def _number(data: bytes) -> int:
    return int.from_bytes(data, "big")
