"""Settings of a process that do not fit the class or hub that the machine has joined."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, NamedTuple

from zbot.log import warn_once
from zbot.transport import background_process, config, membership
from zbot.transport.config import DiscoveryRange
from zbot.transport.meeting_port import meeting_port

if TYPE_CHECKING:
    from zbot.transport.membership import Membership

_FALSE = {"", "0"}
_LOOPBACK = ("127.0.0.1", "localhost", "[::1]")


class Difference(NamedTuple):
    """A setting that does not fit the class or hub that the machine has joined."""

    setting: str  #: e.g. `ROS_DOMAIN_ID=7`
    text: str  #: what zbot does with the setting, and what the user can do
    hides: bool = False  #: whether the class or other machine does not see this process's nodes
    is_logged: bool = True  #: whether a program with nodes logs the text when it starts


def differences(domain_id: int | None = None) -> list[Difference]:
    """Return the settings that do not fit the class or hub that the machine has joined.

    Args:
        domain_id: The domain that the program itself has chosen, or `None`.

    Raises:
        SettingError: The Zenoh configuration file cannot be read or is not valid, or the variable
            for the discovery range has an unknown value.
        MembershipError: The membership file is damaged.
    """
    joined = membership.load()
    if joined is None:
        return []
    domain = _chosen_domain(joined, domain_id) if joined.in_class else None
    found = [domain, _hub_port(joined), _range(joined), _configuration(joined)]
    return [
        difference for difference in (*found, _localhost_only(joined)) if difference is not None
    ]


def missing_hub() -> str:
    """Return a sentence if this machine has joined, but its hub does not run. Otherwise `""`.

    Raises:
        MembershipError: The membership file is damaged.
    """
    joined = membership.load()
    if joined is None or background_process.is_hub_locked():
        return ""
    missing = "the hub of this machine is not running, so"
    if joined.role == "teacher":
        return f"{missing} {place(joined)} is closed: `zbot class start` continues it"
    return f"{missing} {place(joined)} does not see its nodes: `zbot join` starts it again"


def warn(domain_id: int | None) -> None:
    """Log the differences that have `is_logged`, and a missing hub. A process logs them once."""
    texts = [difference.text for difference in differences(domain_id) if difference.is_logged]
    texts += filter(None, [missing_hub()])
    if texts:
        warn_once("\n".join(texts))


def place(joined: Membership) -> str:
    """Return the name of the joined class or hub: `class "Robots"` or `the hub at 10.0.0.2`."""
    return f'class "{joined.class_name}"' if joined.in_class else f"the hub at {joined.host}"


def _chosen_domain(joined: Membership, domain_id: int | None) -> Difference | None:
    of_command = os.environ.get(config.COMMAND_DOMAIN)
    if domain_id is None and not of_command:
        return _ignored_domain(joined)
    chosen = config.domain_id(domain_id)
    if chosen == joined.number:
        return None
    setting = f"--domain {chosen}" if domain_id is None else f"domain_id={chosen}"
    effect = (
        f"{setting} is the domain of student {chosen}"
        if joined.role == "teacher"
        else f"{setting} is used for this program, and the class does not see it"
    )
    return Difference(setting, f"{own_number(joined)}; {effect}", is_logged=domain_id is not None)


def _ignored_domain(joined: Membership) -> Difference | None:
    variable = config.domain_variable()
    if variable is None or variable[1].strip() == str(joined.number):
        return None
    setting = f"{variable[0]}={variable[1]}"
    text = f"{own_number(joined)}; {setting} is ignored; {_way_out(joined)} to use it"
    return Difference(setting, text)


def own_number(joined: Membership) -> str:
    """Return a sentence with the domain of this machine in a class."""
    if joined.role == "teacher":
        return f"this machine is the teacher's in {place(joined)}, and uses domain 0"
    return f"this laptop has number {joined.number} in {place(joined)}"


def _way_out(joined: Membership) -> str:
    return "`zbot class stop`" if joined.role == "teacher" else "`zbot leave`"


def _hub_port(joined: Membership) -> Difference | None:
    text = os.environ.get("ZBOT_HUB_PORT")
    if not text or not joined.hub_port or text == str(joined.hub_port):
        return None
    setting = f"ZBOT_HUB_PORT={text}"
    told = f"this machine joined {place(joined)} with port {joined.hub_port} for its own hub"
    return Difference(setting, f"{told}; {setting} is ignored; {_way_out(joined)} to use it")


def _range(joined: Membership) -> Difference | None:
    variable = config.range_variable()
    if variable is None:
        return None
    found, setting = config.discovery_range(), f"{variable[0]}={variable[1]}"
    if found is DiscoveryRange.OFF:
        text = f"{setting} hides these nodes from {place(joined)} and from all programs: unset it"
        return Difference(setting, text, hides=True)
    if found is DiscoveryRange.SUBNET and joined.in_class:
        text = f"{setting} lets nodes listen on the network; {place(joined)} does not need it"
        return Difference(setting, text, is_logged=False)
    return None


def _localhost_only(joined: Membership) -> Difference | None:
    text = os.environ.get("ROS_LOCALHOST_ONLY", "")
    if text in _FALSE:
        return None
    setting = f"ROS_LOCALHOST_ONLY={text}"
    told = f"{setting} has no effect: {place(joined)} sees the nodes of this machine"
    return Difference(setting, told, is_logged=False)


def _configuration(joined: Membership) -> Difference | None:
    file = config.load()
    if not _connects_elsewhere(file):
        return None
    text = (
        f"{file.source} sets `connect`, so {place(joined)} does not see these nodes: "
        "remove `connect` from the file, or use another folder"
    )
    return Difference(f"the Zenoh configuration {file.source}", text, hides=True)


def _connects_elsewhere(file: config.SessionConfig) -> bool:
    endpoints = json.loads(file.build({}).get_json("connect/endpoints"))
    lists = [endpoints] if isinstance(endpoints, list) else endpoints.values()
    listed = [str(endpoint) for found in lists for endpoint in found]
    ports = (meeting_port(config.domain_id()), config.hub_port())
    own = {f"{host}:{port}" for host in _LOOPBACK for port in ports}
    return bool(listed) and not any(
        any(address in endpoint for address in own) for endpoint in listed
    )
