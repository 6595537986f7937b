"""The hub: a Zenoh router in a Python process that links this machine with others.

Nodes never leave loopback: the domains' meeting points dial the hub of their machine, and hubs dial
one other hub, whose address they were told. So nothing depends on multicast, and a laptop behind an
access point that isolates its clients is reached like any other.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from zbot.classroom.errors import HubPortError
from zbot.transport.config import port_of
from zbot.transport.errors import SessionError
from zbot.transport.session import open_hub, process_facts
from zbot.version import __version__

if TYPE_CHECKING:
    import zenoh

# A hub that says nothing for this long is taken for lost: short enough for a teacher to notice a
# laptop that went to sleep, long enough for TCP to repeat three times what Wi-Fi loses.
_LEASE_MS = 4000
# In a lease, and each is acknowledged: thirty idle laptops cost their teacher 4 kB/s.
_KEEP_ALIVES = 2
# As soon as the other hub is back everything has to be; but a hundred laptops must not flood it.
_RETRY = {"period_init_ms": 250, "period_max_ms": 500, "period_increase_factor": 2}
_HANDSHAKE_MS = 3000  # networks lose packets
# Laptops that come back at once after a restart wait for each other here.
_ACCEPT_PENDING = 500
_ADMIN_MESSAGES = ["declare_queryable", "query", "reply"]


def open_access() -> dict[str, Any]:
    """Return rules that let everything through but the admin space.

    Each session has one; that of a class of thirty would be asked, and would answer, whenever
    somebody looks around.
    """
    rule = {
        "id": "admin space",
        "permission": "deny",
        "flows": ["ingress", "egress"],
        "messages": _ADMIN_MESSAGES,
        "key_exprs": ["@/**"],
    }
    return {
        "enabled": True,
        "default_permission": "allow",
        "rules": [rule],
        "subjects": [{"id": "everybody"}],
        "policies": [{"rules": ["admin space"], "subjects": ["everybody"]}],
    }


@dataclass(frozen=True)
class HubSettings:
    """How a hub is linked."""

    listen: tuple[str, ...]  #: Zenoh endpoints; one must be that which this machine's nodes dial
    connect: tuple[str, ...] = ()  #: those of the hub that it dials
    extra: dict[str, Any] = field(
        default_factory=dict
    )  #: more of Zenoh's configuration, which wins

    def zenoh_settings(self) -> dict[str, Any]:
        """Return Zenoh's configuration paths and values."""
        return {
            "transport/link/tx/lease": _LEASE_MS,
            "transport/link/tx/keep_alive": _KEEP_ALIVES,
            # While a hub waits to get rid of what must not be dropped it does not redial (in
            # microseconds).
            "transport/link/tx/queue/congestion_control/block/wait_before_close": _LEASE_MS * 1000,
            "transport/unicast/accept_pending": _ACCEPT_PENDING,
            "transport/unicast/open_timeout": _HANDSHAKE_MS,
            "transport/unicast/accept_timeout": _HANDSHAKE_MS,
            "connect/retry": _RETRY,
            "access_control": open_access(),
            **self.extra,
        }


def open_router(settings: HubSettings) -> zenoh.Session:
    """Open a hub's session.

    Raises:
        HubPortError: An endpoint to listen on is taken.
    """
    facts = process_facts(__version__)
    try:
        return open_hub(
            list(settings.listen), list(settings.connect), settings.zenoh_settings(), facts
        )
    except SessionError as exc:
        raise HubPortError(" and ".join(settings.listen), str(exc)) from exc


def dialled_links(session: zenoh.Session, settings: HubSettings) -> list[str]:
    """Return the addresses of the links that a hub made itself, to one that it dials."""
    listening = {port_of(endpoint) for endpoint in settings.listen}
    dialled = {port_of(endpoint) for endpoint in settings.connect}
    return [
        str(link.dst)
        for link in session.info.links()
        if port_of(str(link.dst)) in dialled and port_of(str(link.src)) not in listening
    ]
