"""Tests of programs that share a home folder, but not their process ids or their ports."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from typing import TYPE_CHECKING

import pytest

from tests.conftest import wait_until
from zbot.transport import router_process

if TYPE_CHECKING:
    from tests.conftest import Start

# The options that the tests of this module give to `unshare`.
NETWORK = ("--net",)
PROCESSES = ("--pid", "--fork", "--mount-proc", "--kill-child")


def _has_namespaces() -> bool:
    if not hasattr(os, "geteuid") or os.geteuid() != 0 or shutil.which("unshare") is None:
        return False
    words = ["unshare", "--net", *PROCESSES, "ip", "link", "set", "lo", "up"]
    return subprocess.run(words, check=False, capture_output=True).returncode == 0


pytestmark = [
    pytest.mark.own_dialect("ROS 2 has a router that the user starts, and no meeting port"),
    pytest.mark.skipif(not _has_namespaces(), reason="namespaces need root, unshare and ip"),
]

TALKER = """
import sys, zbot
from zbot.transport import router_process

context = zbot.Context()
context.init([])
node = zbot.Node(sys.argv[1], context=context)
print("router", router_process.pid(context.get_domain_id()), flush=True)
zbot.spin(node)
"""


@pytest.fixture
def domain(free_domain: int) -> int:
    """Return a domain whose router is a process, as outside of tests."""
    return free_domain


def test_two_network_namespaces_have_a_router_each(start: Start, domain: int) -> None:
    here = start("here", source=TALKER)
    here.wait_for("router")
    router = router_process.pid(domain)
    assert router is not None
    assert wait_until(lambda: router_process.age_s(domain) > 1.5)  # a younger one is never ended
    script = f"ip link set lo up && exec {sys.executable} -c '{TALKER}' there"
    there = start("unshare", *NETWORK, "sh", "-c", script)
    line = there.wait_for("router")
    assert line.split()[1] not in {"None", str(router)}
    assert router_process.pid(domain) == router
    assert not any("did not answer" in text for text in (*here.new_lines(), *there.new_lines()))


def test_a_container_with_the_same_ports_uses_the_router_and_never_ends_it(
    start: Start, domain: int
) -> None:
    here = start("here", source=TALKER)
    here.wait_for("router")
    router = router_process.pid(domain)
    there = start("unshare", *PROCESSES, sys.executable, "-c", TALKER, "there")
    assert there.wait_for("router") == "router None"
    listed = start("unshare", *PROCESSES, sys.executable, "-m", "zbot_cli", "node", "list")
    assert listed.wait() == 0
    assert sorted(listed.lines) == ["/here", "/there"]
    killed = start("unshare", *PROCESSES, sys.executable, "-m", "zbot_cli", "node", "kill", "here")
    assert killed.wait() == 1
    assert f"pid {here.process.pid}" in killed.lines[-1]
    assert here.process.poll() is None
    assert router_process.pid(domain) == router
