"""Configuration of sessions that speak ROS 2's Zenoh dialect.

The environment variables that change it are the same as for `rmw_zenoh_cpp`, so a user of ROS 2
does not have to set other variables.
"""

from __future__ import annotations

import json
import os
from typing import Any

import zenoh

from zbot.text.whole_number import whole_number
from zbot.transport import config
from zbot.transport.config import DROP_WAIT_US, ONE_DIALS, OPEN_TIMEOUT_MS, SessionConfig
from zbot.transport.errors import SettingError, config_error

ROUTER_ENDPOINT = "tcp/localhost:7447"
_SESSION_FILE = "ZENOH_SESSION_CONFIG_URI"
_ROUTER_FILE = "ZENOH_ROUTER_CONFIG_URI"
_OVERRIDE = "ZENOH_CONFIG_OVERRIDE"
_ATTEMPTS = "ZENOH_ROUTER_CHECK_ATTEMPTS"
_MAX_DIGITS = 9

# The values of rmw_zenoh's own configuration files. These files are equal in all distributions of
# ROS 2. Only the timeouts of sessions are zbot's own, and the router's number of keep-alives. With
# rmw_zenoh's lease of 60 s, a program with a suspended subscriber could need 60 s to end.
_COMMON: dict[str, Any] = {
    "adminspace/enabled": True,
    "queries_default_timeout": 600_000,
    "scouting/delay": 1,  # ms that Zenoh waits in open()
    "scouting/multicast/enabled": False,
    "timestamping/enabled": {"router": True, "peer": True, "client": True},
    "transport/shared_memory/enabled": False,
    "transport/unicast/accept_pending": 10_000,
    "transport/unicast/max_sessions": 10_000,
}
_SESSION: dict[str, Any] = {
    **_COMMON,
    "connect/endpoints": [ROUTER_ENDPOINT],
    "connect/exit_on_failure": False,
    "connect/retry": {"period_init_ms": 100, "period_max_ms": 1000, "period_increase_factor": 2},
    "connect/timeout_ms": -1,
    "listen/endpoints": ["tcp/localhost:0"],
    "scouting/gossip/autoconnect": {"router": [], "peer": ["router", "peer"]},
    "scouting/gossip/autoconnect_strategy": ONE_DIALS,
    "scouting/gossip/target": {"router": ["router", "peer"], "peer": ["router"]},
    "transport/link/tx/queue/congestion_control/block/wait_before_close": 60_000_000,
    "transport/link/tx/queue/congestion_control/drop/wait_before_drop": DROP_WAIT_US,
    "transport/unicast/open_timeout": OPEN_TIMEOUT_MS,
}
_ROUTER: dict[str, Any] = {
    **_COMMON,
    "connect/exit_on_failure": False,
    "connect/timeout_ms": -1,
    "listen/exit_on_failure": True,
    "listen/timeout_ms": 0,
    "routing/router/peers_failover_brokering": False,
    "transport/link/tx/lease": 60_000,
    # One every 2.5 s. A board with zenoh-pico closes its link if nothing arrives for 10 s.
    "transport/link/tx/keep_alive": 24,
    "transport/link/tx/queue/congestion_control/block/wait_before_close": 5_000_000,
}


class RmwConfig:
    """Configuration of ROS 2's sessions on this machine. The override variable overrides the files.

    Raises:
        SettingError: A file cannot be read, or an override is not valid.
    """

    def __init__(self) -> None:
        own = config.load()
        base = SessionConfig("rmw_zenoh's configuration", "{}") if own.is_packaged else own
        self._session = config.named_by((_SESSION_FILE,)) or base
        self._router = config.named_by((_ROUTER_FILE,)) or SessionConfig(base.source, "{}")
        self._overrides = _overrides()

    @property
    def names_mode(self) -> bool:
        """Whether the override variable sets the mode of sessions, e.g. `client`."""
        return "mode" in self._overrides

    def session(self, fill: dict[str, Any], force: dict[str, Any] | None = None) -> zenoh.Config:
        """Return the configuration of a session. The arguments are those of `SessionConfig.build`.

        Raises:
            SettingError: The file or an override is not valid.
        """
        return self._overridden(self._session.build({"mode": "peer", **_SESSION, **fill}), force)

    def router(self, fill: dict[str, Any], force: dict[str, Any]) -> zenoh.Config:
        """Return the configuration of a router.

        Raises:
            SettingError: The file or an override is not valid.
        """
        return self._overridden(
            self._router.build({**_ROUTER, **fill}), {"mode": "router", **force}
        )

    def _overridden(self, built: zenoh.Config, force: dict[str, Any] | None) -> zenoh.Config:
        for path, text in self._overrides.items():
            try:
                built.insert_json5(path, text)
            except zenoh.ZError as exc:
                raise config_error(f"{_OVERRIDE} ({path}={text})", str(exc)) from exc
        for path, value in (force or {}).items():
            built.insert_json5(path, json.dumps(value))
        return built


def _overrides() -> dict[str, str]:
    found: dict[str, str] = {}
    for part in os.environ.get(_OVERRIDE, "").split(";"):
        path, equals, text = part.partition("=")
        if not part.strip():
            continue
        if not equals or not path.strip():
            reason = f'{part!r} is not `path=value`, for example mode="client"'
            raise config_error(_OVERRIDE, reason)
        found[path.strip()] = text.strip()
    return found


def router_attempts() -> int | None:
    """Return how often a program looks for a router at its start. `None` means without a limit.

    Raises:
        SettingError: The variable is not a whole number.
    """
    text = os.environ.get(_ATTEMPTS, "").strip() or "1"
    if whole_number(text.removeprefix("-"), _MAX_DIGITS) is None:
        raise SettingError(
            f"{_ATTEMPTS} is {text!r}, but it must be a whole number: "
            "0 waits for a router for ever, and a negative number does not look for one"
        )
    return int(text) or None


def endpoints(built: zenoh.Config, path: str) -> list[str]:
    """Return the endpoints in a configuration, e.g. at the path `connect/endpoints`."""
    value = config.setting(built, path)
    if isinstance(value, dict):  # a list for each mode
        value = value.get(config.setting(built, "mode")) or []
    return [str(item["endpoint"] if isinstance(item, dict) else item) for item in value]


def is_local(endpoint: str) -> bool:
    """Return whether an endpoint is on this machine."""
    address = endpoint.split("/", 1)[-1].split("?", 1)[0].split("#", 1)[0]
    host = address.rpartition(":")[0].strip("[]")
    return (
        endpoint.startswith(("unixsock-stream", "unixpipe"))
        or host in {"localhost", "::1"}
        or host.startswith("127.")
    )
