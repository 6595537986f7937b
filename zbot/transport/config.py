"""Settings of a program: environment variables and the Zenoh configuration file."""

from __future__ import annotations

import enum
import json
import os
from pathlib import Path
from typing import Any, NamedTuple

import zenoh

from zbot.text.whole_number import whole_number
from zbot.transport import membership
from zbot.transport.errors import SettingError, config_error, discovery_range_error, port_error

MAX_DOMAIN_ID = 232  #: ROS 2's own limit, so that lesson sheets for ROS 2 are valid here
MEETING_PORT = 7450  #: port of the router of domain 0 on 127.0.0.1 (domain n: 7450 + n)
# Time that a put with Zenoh's congestion control `DROP` waits for space in the queue. The queue is
# soon full if a busy machine does not run the sending thread. Beside six busy processes, bursts
# lost 14 to 37 % of their messages with Zenoh's default of 1000 us. With 20 ms, one burst was lost.
# DDS also waits 100 ms by default. A suspended subscriber makes its publisher wait only once, and
# not at each message.
DROP_WAIT_US = 100_000
# Zenoh opens a link in 5 ms, on a busy machine in more than a second. If this limit is reached in
# the last step, the link stays half open: one side never reads (docs/design/zenoh-faults.md). A
# program on the port may accept a link and never answer. With Zenoh's default limit of 10 s,
# close() would then wait for 10 s.
OPEN_TIMEOUT_MS = 5000
#: Only one of two peers connects to the other. This halves the work when many programs start.
ONE_DIALS = {"peer": {"to_router": "always", "to_peer": "greater-zid"}}
HUB_PORT = 7447  #: Zenoh's router port, on which hubs listen

_PACKAGED = "the packaged zenoh.json5"
_FILE_VARIABLES = ("ZBOT_CONFIG", "ZENOH_CONFIG")
_DOMAIN_VARIABLES = ("ZBOT_DOMAIN_ID", "ROS_DOMAIN_ID")
#: Variable with the domain of a command and of its programs. `zbot --domain` sets the variable.
COMMAND_DOMAIN = "ZBOT_COMMAND_DOMAIN"
_MAX_PORT = 65535
_RANGE_VARIABLES = ("ZBOT_DISCOVERY_RANGE", "ROS_AUTOMATIC_DISCOVERY_RANGE")


class DiscoveryRange(enum.Enum):
    """Range in which a program looks for other programs."""

    OFF = "OFF"  #: nowhere
    LOCALHOST = "LOCALHOST"  #: on this machine (the default)
    SUBNET = "SUBNET"  #: on this machine, and by multicast on the network


def _first_set(variables: tuple[str, ...]) -> tuple[str, str] | None:
    return next(((name, os.environ[name]) for name in variables if os.environ.get(name)), None)


def domain_id(given: int | None = None) -> int:
    """Return the domain of this process's nodes.

    It is `given`, else the domain of `zbot --domain`. Otherwise, in a class, it is the student's
    number, and 0 for the teacher. Without a class, it is `$ZBOT_DOMAIN_ID`, else `$ROS_DOMAIN_ID`,
    else 0.

    Raises:
        SettingError: The domain is not an integer from 0 to 232.
    """
    if given is not None:
        return _checked_domain("domain_id", given)
    of_command = os.environ.get(COMMAND_DOMAIN)
    if of_command:
        return _checked_domain("--domain", of_command)
    joined = membership.load()
    if joined is not None and joined.in_class:
        return _checked_domain("the student's number", joined.number)
    found = _first_set(_DOMAIN_VARIABLES)
    return 0 if found is None else _checked_domain(*found)


def domain_variable() -> tuple[str, str] | None:
    """Return the environment variable that sets the domain, and its text, or `None`."""
    return _first_set(_DOMAIN_VARIABLES)


def _checked_domain(source: str, value: object) -> int:
    try:
        number = int(value) if isinstance(value, (int, str)) else -1
    except ValueError:
        number = -1
    if not 0 <= number <= MAX_DOMAIN_ID:
        raise SettingError(
            f"{source} is {value!r}, but a domain is a whole number from 0 to {MAX_DOMAIN_ID}: "
            f"set such a number, for example {source}=7"
        )
    return number


def hub_port() -> int:
    """Return the port of this machine's own hub.

    It is the port in the membership file, else `$ZBOT_HUB_PORT`, else 7447.

    Raises:
        SettingError: The variable does not hold a port.
    """
    joined = membership.load()
    if joined is not None and joined.hub_port:
        return joined.hub_port
    text = os.environ.get("ZBOT_HUB_PORT") or str(HUB_PORT)
    port = whole_number(text)
    if port is None or not 0 < port <= _MAX_PORT:
        raise port_error("ZBOT_HUB_PORT", text)
    return port


def discovery_range() -> DiscoveryRange:
    """Return the range in `$ZBOT_DISCOVERY_RANGE`, else in ROS 2's variable, else LOCALHOST.

    Raises:
        SettingError: The variable holds an unknown word.
    """
    found = range_variable()
    if found is None or found[1].upper() == "SYSTEM_DEFAULT":
        return DiscoveryRange.LOCALHOST
    try:
        return DiscoveryRange(found[1].upper())
    except ValueError:
        raise discovery_range_error(*found) from None


def range_variable() -> tuple[str, str] | None:
    """Return the environment variable that sets the discovery range, and its text, or `None`."""
    return _first_set(_RANGE_VARIABLES)


class SessionConfig(NamedTuple):
    """The text of a Zenoh configuration file, and the file's name."""

    source: str
    text: str

    def build(self, fill: dict[str, Any], force: dict[str, Any] | None = None) -> zenoh.Config:
        """Return a configuration. `force` overrides the file, and the file overrides `fill`.

        Args:
            fill: Zenoh's configuration paths and values, for paths that the file does not set.
            force: Paths and values that this kind of session needs. They replace the file's values.

        Raises:
            SettingError: The file is not a valid Zenoh configuration, or it sets `id`.
        """
        try:
            built: zenoh.Config = zenoh.Config.from_json5(self.text)
        except zenoh.ZError as exc:
            raise config_error(self.source, str(exc)) from exc
        if built.get_json("id") != "null":
            reason = "remove `id`: every session of a program needs a different one"
            raise config_error(self.source, reason)
        default = zenoh.Config()
        for path, value in fill.items():
            if path == "metadata" and isinstance(given := setting(built, path), dict):
                built.insert_json5(path, json.dumps(given | value))
            elif built.get_json(path) == default.get_json(path) and not self._mentions(path):
                built.insert_json5(path, json.dumps(value))
        for path, value in (force or {}).items():
            built.insert_json5(path, json.dumps(value))
        return built

    @property
    def is_packaged(self) -> bool:
        """Whether this is zbot's own file, which changes no setting."""
        return self.source == _PACKAGED

    def _mentions(self, path: str) -> bool:
        # adminspace is off by default, so its value does not show whether the file switches it off.
        lines = (line.split("//")[0] for line in self.text.splitlines())
        return path.startswith("adminspace") and any("adminspace" in line for line in lines)


def load() -> SessionConfig:
    """Return the file in `$ZBOT_CONFIG` or `$ZENOH_CONFIG`, else `./zenoh.json5`, else zbot's.

    Raises:
        SettingError: The file cannot be read.
    """
    found = named_by(_FILE_VARIABLES)
    if found is not None:
        return found
    local = Path("zenoh.json5")
    return _read(local) if local.is_file() else _packaged()


def named_by(variables: tuple[str, ...]) -> SessionConfig | None:
    """Return the file in the first environment variable that is set, or `None`.

    Raises:
        SettingError: The file cannot be read.
    """
    found = _first_set(variables)
    return None if found is None else _read(Path(found[1]))


def _read(path: Path) -> SessionConfig:
    try:
        return SessionConfig(str(path), path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError) as exc:
        raise config_error(str(path), getattr(exc, "strerror", None) or str(exc)) from exc


def _packaged() -> SessionConfig:
    here = Path(__file__).parents[1]
    # In a checkout the file is beside the package, not inside it.
    candidates = (here.parent / "zenoh.json5", here / "zenoh.json5")
    shipped = candidates[0] if (here.parent / "pyproject.toml").is_file() else candidates[1]
    return SessionConfig(_PACKAGED, shipped.read_text(encoding="utf-8"))


def setting(built: zenoh.Config, path: str) -> Any:
    """Return the value at a path of a Zenoh configuration."""
    return json.loads(built.get_json(path))


def port_of(locator: str) -> str:
    """Return the port of a Zenoh endpoint or locator: 7447 for `tcp/[::1]:7447?rel=1#iface=lo`."""
    return locator.split("?", 1)[0].split("#", 1)[0].rpartition(":")[2]
