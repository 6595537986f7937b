"""Domain of one test: reserved on this machine, and apart from its class and its network."""

from __future__ import annotations

import os
import shutil
import socket
import time
from contextlib import contextmanager
from typing import TYPE_CHECKING

from zbot.errors import WrongStateError
from zbot.package.user_folders import definitions_folder
from zbot.transport import config, membership
from zbot.transport.config import COMMAND_DOMAIN, MAX_DOMAIN_ID, MEETING_PORT
from zbot.transport.rmw_choice import RMW_VARIABLE, RMW_ZENOH
from zbot.transport.rmw_meeting import RmwRouter
from zbot.transport.session import MeetingPoint

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    import pytest
    import zenoh

_RESERVATION_PORT = MEETING_PORT + 1000
_NO_HUB = "9"  # the port "discard", which nobody uses


@contextmanager
def reserved_domain(largest: int = MAX_DOMAIN_ID) -> Iterator[int]:
    """Reserve an unused domain of this machine until the end of a block.

    Args:
        largest: The largest number to choose. The smallest is 1.

    Raises:
        WrongStateError: All these domains are in use.
    """
    first = time.monotonic_ns() // 1000 % largest
    for offset in range(largest):
        candidate = 1 + (first + offset) % largest
        # A meeting port may be free for moments of its test: a second port reserves it.
        with _bound(_RESERVATION_PORT + candidate) as is_ours:
            if is_ours and _is_free(MEETING_PORT + candidate):
                yield candidate
                return
    raise WrongStateError("all domains of this machine are in use: end other programs")


@contextmanager
def _bound(port: int) -> Iterator[bool]:
    with socket.socket() as holder:
        if os.name != "nt":  # on Windows, two sockets could have the port with this option
            holder.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            holder.bind(("127.0.0.1", port))
            holder.listen()
        except OSError:
            yield False
        else:
            yield True


def _is_free(port: int) -> bool:
    with _bound(port) as is_free:
        return is_free


def isolate(monkeypatch: pytest.MonkeyPatch, domain: int, folder: Path) -> None:
    """Set the environment so that programs use only `domain`, and only on this machine.

    On a machine that has joined a class, they get other settings, below `folder`.
    """
    for name in ("ZBOT_DOMAIN_ID", "ROS_DOMAIN_ID"):
        monkeypatch.setenv(name, str(domain))
    monkeypatch.delenv(COMMAND_DOMAIN, raising=False)
    monkeypatch.setenv("ZBOT_DISCOVERY_RANGE", config.DiscoveryRange.LOCALHOST.value)
    monkeypatch.setenv("ZBOT_HUB_PORT", _NO_HUB)
    if membership.load() is not None:
        definitions, settings = definitions_folder(), folder / "settings"
        monkeypatch.setenv("XDG_CONFIG_HOME", str(settings))
        if definitions.is_dir():
            shutil.copytree(definitions, definitions_folder())


def open_router(domain: int, monkeypatch: pytest.MonkeyPatch) -> zenoh.Session | None:
    """Open the domain's router in this process, which is faster than a process of its own."""
    if os.environ.get(RMW_VARIABLE) != RMW_ZENOH:
        return MeetingPoint(config.load(), domain, config.discovery_range(), {}).open_router()
    endpoint = f"tcp/127.0.0.1:{MEETING_PORT + domain}"
    monkeypatch.setenv("ZENOH_CONFIG_OVERRIDE", f'connect/endpoints=["{endpoint}"]')
    return RmwRouter([endpoint], []).open()
