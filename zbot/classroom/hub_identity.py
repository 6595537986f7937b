"""Identity of a hub, which the keys of a PIN depend on: the address or certificate of the hub."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import zenoh


def certificate_identity(fingerprint: str) -> str:
    """Return the identity of a hub that has shown a certificate."""
    return f"certificate/{fingerprint}"


def dialled_identity(session: zenoh.Session) -> str:
    """Return the address that a client of a hub has dialled, such as `tcp/192.168.1.10:7447`.

    A host name is not enough, because only the laptop knows it. The link has the IP address.
    """
    return next((str(link.dst) for link in session.info.links()), "")


def own_identities(session: zenoh.Session) -> set[str]:
    """Return the addresses at which a hub is reached now: its own end of each link.

    The link of a laptop that asks for admission is among the links.
    """
    return {str(link.src) for link in session.info.links()}
