"""Network impairment as on bad Wi-Fi: frames are delayed, reordered or lost."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import dataclass
from typing import TYPE_CHECKING

from tests.classroom.machine import PROGRAMS
from tests.classroom.network import Batch, ip, tc
from tests.conftest import Program

if TYPE_CHECKING:
    from tests.classroom.machine import Machine
    from tests.classroom.testbed import LanTestbed


@dataclass(frozen=True)
class Impairment:
    """Impairment of each frame, in each direction."""

    delay_ms: float = 20
    jitter_ms: float = 10  #: uniform, so that frames overtake each other
    loss: float = 0.02  #: 0 to 1


def impair(testbed: LanTestbed, impairment: Impairment, machines: list[Machine]) -> str:
    """Impair the network of some machines from now on.

    Returns:
        The tool: `tc netem`, or `relay` if the kernel has no netem. The relay delays and drops
        frames in a process; for the kernel's TCP, the only difference is that process's own delay
        of about 0.1 ms.
    """
    try:
        for machine in machines:
            _add_netem(machine.namespace, "eth0", impairment)
            _add_netem(testbed.bridge, machine.name, impairment)
    except subprocess.CalledProcessError as exc:
        if "qdisc kind is unknown" not in exc.stderr:
            raise
        _relay(testbed, impairment, machines)
        return "relay"
    return "tc netem"


def _add_netem(namespace: str, device: str, impairment: Impairment) -> None:
    late = ["delay", f"{impairment.delay_ms}ms", f"{impairment.jitter_ms}ms"]
    lost = ["loss", f"{impairment.loss * 100}%"]
    tc(namespace, "qdisc", "add", "dev", device, "root", "netem", *late, *lost)


def _relay(testbed: LanTestbed, impairment: Impairment, machines: list[Machine]) -> None:
    between = testbed.add_namespace("impairment")
    for machine in machines:
        ip("-n", testbed.bridge, "link", "set", machine.name, "netns", between)
        with Batch(between) as batch:
            plain = ["addrgenmode", "none", "up"]
            batch.add("link", "set", machine.name, *plain)
            outside = f"{machine.name}-br"
            peer = ["peer", "name", machine.name, "netns", testbed.bridge]
            batch.add("link", "add", outside, "type", "veth", *peer)
            batch.add("link", "set", outside, *plain)
        machine.reconnect()
    numbers = [str(impairment.delay_ms), str(impairment.jitter_ms), str(impairment.loss)]
    pairs = [f"{machine.name}:{machine.name}-br" for machine in machines]
    inside = ["ip", "netns", "exec", between, sys.executable, str(PROGRAMS / "relay.py")]
    relay = Program([*inside, *numbers, *pairs], PROGRAMS, {})
    testbed.adopt(relay)
    relay.wait_for("relaying")
