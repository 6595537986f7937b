"""Identity of a hub: its address or certificate. The keys of the PIN check depend on it."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import zenoh


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
