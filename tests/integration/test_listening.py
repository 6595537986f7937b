"""Test that a node opens no port to the network."""

from __future__ import annotations

import contextlib
import socket
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import Program

LISTENS = "0A"


def open_addresses(pid: int) -> set[str]:
    """Return the addresses that a process listens on, by TCP or by UDP (Linux)."""
    links = []
    for link in Path(f"/proc/{pid}/fd").iterdir():
        with contextlib.suppress(FileNotFoundError):  # it was closed meanwhile
            links.append(str(link.readlink()))
    inodes = {link[8:-1] for link in links if link.startswith("socket:[")}
    found = set()
    for name in ("tcp", "tcp6", "udp", "udp6"):
        for line in Path(f"/proc/{pid}/net/{name}").read_text().splitlines()[1:]:
            row = line.split()
            if row[9] in inodes and (row[3] == LISTENS or name.startswith("udp")):
                found.add(_readable(row[1].split(":")[0]))
    return found


def _readable(address: str) -> str:
    words = [bytes.fromhex(address[start : start + 8])[::-1] for start in range(0, len(address), 8)]
    family = socket.AF_INET6 if len(words) == 4 else socket.AF_INET
    return socket.inet_ntop(family, b"".join(words))


@pytest.mark.skipif(not Path("/proc/self/net/tcp").exists(), reason="needs Linux's /proc")
def test_a_node_listens_on_loopback_only(start: Callable[..., Program]) -> None:
    node = start("zbot", "run", "talker")
    node.wait_for("Publishing")
    assert open_addresses(node.process.pid) == {"127.0.0.1"}
