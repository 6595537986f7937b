"""Hub: a Zenoh router in a Python process that links this machine with other machines.

Nodes connect only on loopback, to the router of their domain (see `zbot.transport.session`). This
router connects to the hub of its machine, and the hub connects to one other hub at a given address.
So hubs need no multicast, and they work even if an access point isolates its clients from each
other.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from zbot.classroom.errors import hub_port_error
from zbot.transport.config import port_of
from zbot.transport.errors import SessionError
from zbot.transport.session import open_hub

if TYPE_CHECKING:
    import zenoh

# A link without messages for this time is closed. The time is short enough to notice soon that a
# laptop sleeps, and long enough for TCP to repeat a packet three times if Wi-Fi loses it.
_LEASE_MS = 4000
# Number of keep-alive messages in a lease. TCP acknowledges each message, so thirty idle laptops
# cause 4 kB/s at the teacher's hub.
_KEEP_ALIVES = 2
# Pauses between two attempts to connect to a hub. They are short, so that laptops are linked soon
# after the hub is back, but long enough that a hundred laptops do not flood the hub.
_RETRY = {"period_init_ms": 250, "period_max_ms": 500, "period_increase_factor": 2}
_HANDSHAKE_MS = 3000  # long enough for TCP to repeat lost packets
# Limit of unfinished handshakes. All laptops reconnect together after the teacher's hub restarts.
_ACCEPT_PENDING = 500
_ADMIN_MESSAGES = ["declare_queryable", "query", "reply"]


def open_access() -> dict[str, Any]:
    """Return access rules that allow everything except the admin space.

    Each session has an admin space. Without this rule, all sessions in the classroom would answer
    one query of a student.
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
    """Endpoints and Zenoh settings of a hub."""

    listen: tuple[str, ...]  #: Zenoh endpoints (this machine's routers connect to one of them)
    connect: tuple[str, ...] = ()  #: endpoints of the hub that this hub connects to
    extra: dict[str, Any] = field(default_factory=dict)  #: Zenoh settings that override the others

    def zenoh_settings(self) -> dict[str, Any]:
        """Return Zenoh's configuration paths and values."""
        return {
            "transport/link/tx/lease": _LEASE_MS,
            "transport/link/tx/keep_alive": _KEEP_ALIVES,
            # Longest wait to send a reliable message, in microseconds. A waiting hub cannot
            # reconnect.
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
        ClassroomError: Another program listens on an endpoint.
    """
    try:
        return open_hub(list(settings.listen), list(settings.connect), settings.zenoh_settings())
    except SessionError as exc:
        raise hub_port_error(" and ".join(settings.listen), str(exc)) from exc


def dialled_links(session: zenoh.Session, settings: HubSettings) -> list[str]:
    """Return the remote addresses of a hub's outgoing links."""
    listening = {port_of(endpoint) for endpoint in settings.listen}
    dialled = {port_of(endpoint) for endpoint in settings.connect}
    return [
        str(link.dst)
        for link in session.info.links()
        if port_of(str(link.dst)) in dialled and port_of(str(link.src)) not in listening
    ]
