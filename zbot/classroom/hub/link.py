"""Links between hubs, which use plain TCP or TLS, and the identity of the hub at their end."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from zbot.classroom.hub.address import EVERYWHERE, Address, own_addresses
from zbot.transport.session import hub_endpoint

if TYPE_CHECKING:
    import zenoh

    from zbot.security.keystore import Identity


@dataclass(frozen=True)
class Link:
    """Protocol of the links between hubs.

    Attributes:
        keystore: Folder of this machine's certificate. Empty means plain TCP.
    """

    keystore: str = ""

    @classmethod
    def named(cls, folder: Path | None) -> Link:
        """Return the link that uses the folder given with `--keystore`.

        Raises:
            SecurityError: The folder does not exist, or zbot cannot choose a certificate in it.
        """
        if folder is None:
            return cls()
        from zbot.security.keystore import identity  # noqa: PLC0415 - few use certificates

        return cls(str(identity(folder).folder.absolute()))

    @property
    def settings(self) -> dict[str, Any]:
        """Zenoh's configuration keys for the link, with their values."""
        if not self.keystore:
            return {}
        from zbot.security.tls import tls_settings  # noqa: PLC0415 - few use certificates

        return tls_settings(self._identity)

    @property
    def _identity(self) -> Identity:
        from zbot.security.keystore import Identity  # noqa: PLC0415 - few use certificates

        return Identity(Path(self.keystore))

    def endpoint(self, address: Address) -> str:
        """Return the Zenoh endpoint of an address."""
        return f"tls/{address}" if self.keystore else address.endpoint

    def listening(self, address: Address) -> tuple[str, ...]:
        """Return the endpoints on which a hub listens: an address for other machines, and loopback.

        Loopback uses plain TCP, because the nodes of the hub's machine have no certificates.
        """
        own = hub_endpoint()
        if not self.keystore:
            shared = address.host == EVERYWHERE and own.endswith(f":{address.port}")
            return (address.endpoint,) if shared else (address.endpoint, own)
        hosts = own_addresses() if address.host == EVERYWHERE else [address.host]
        return (*(self.endpoint(Address(host, address.port)) for host in hosts), own)

    def check_listening(self, host: str) -> None:
        """Check that other machines can join this machine at an address.

        Raises:
            SecurityError: This machine's certificate is not valid for the address.
        """
        if self.keystore:
            from zbot.security.tls import check_listening  # noqa: PLC0415 - few use certificates

            check_listening(self._identity, host)

    def fingerprint(self) -> str:
        """Return the fingerprint of this machine's certificate, or an empty text for plain TCP.

        Raises:
            SecurityError: This machine's certificate is missing or damaged.
        """
        if not self.keystore:
            return ""
        from zbot.security.certificate import facts  # noqa: PLC0415 - few use certificates

        return facts(self._identity.certificate).fingerprint

    def check_dialling(self, address: Address) -> str:
        """Check that this machine and the hub at an address accept each other's certificates.

        Returns:
            The fingerprint of the hub's certificate, or an empty text for plain TCP.

        Raises:
            SecurityError: One side does not accept the other's certificate. The message says which
                certificate is wrong and why.
        """
        if not self.keystore:
            return ""
        from zbot.security.tls import check_dialling  # noqa: PLC0415 - few use certificates

        return check_dialling(self._identity, address.host, address.port).fingerprint


PLAINTEXT = Link()


def certificate_identity(fingerprint: str) -> str:
    """Return the identity of a hub that has shown a certificate."""
    return f"certificate/{fingerprint}"


def dialled_identity(session: zenoh.Session) -> str:
    """Return the address that a hub's client is connected to, such as `tcp/192.168.1.10:7447`.

    A host name is not enough, because only the laptop knows it. The link has the IP address.
    """
    return next((str(link.dst) for link in session.info.links()), "")


def own_identities(session: zenoh.Session) -> set[str]:
    """Return the addresses of a hub at which other sessions are connected now.

    The laptop that asks for admission is one of these sessions.
    """
    return {str(link.src) for link in session.info.links()}
