"""Bad Wi-Fi: frames that are late, overtake each other, or never arrive."""

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
    from tests.classroom.rig import Rig


@dataclass(frozen=True)
class Weather:
    """What happens to each frame, in each direction."""

    delay_ms: float = 20
    jitter_ms: float = 10  #: uniform, so that frames overtake each other
    loss: float = 0.02  #: 0 to 1


def spoil(rig: Rig, weather: Weather, machines: list[Machine]) -> str:
    """Let some machines have bad Wi-Fi from now on.

    Returns:
        By what means: `tc netem`, or `relay` where the kernel has none. The relay delays and drops
        the same frames in a process, and the kernel's TCP sees no difference but that process's
        own delay of about 0.1 ms.
    """
    try:
        for machine in machines:
            _add_netem(machine.namespace, "eth0", weather)
            _add_netem(rig.air, machine.name, weather)
    except subprocess.CalledProcessError as exc:
        if "qdisc kind is unknown" not in exc.stderr:
            raise
        _relay(rig, weather, machines)
        return "relay"
    return "tc netem"


def _add_netem(namespace: str, device: str, weather: Weather) -> None:
    late = ["delay", f"{weather.delay_ms}ms", f"{weather.jitter_ms}ms"]
    lost = ["loss", f"{weather.loss * 100}%"]
    tc(namespace, "qdisc", "add", "dev", device, "root", "netem", *late, *lost)


def _relay(rig: Rig, weather: Weather, machines: list[Machine]) -> None:
    between = rig.add_namespace("weather")
    for machine in machines:
        ip("-n", rig.air, "link", "set", machine.name, "netns", between)
        with Batch(between) as batch:
            plain = ["addrgenmode", "none", "up"]
            batch.add("link", "set", machine.name, *plain)
            outside = f"{machine.name}-air"
            peer = ["peer", "name", machine.name, "netns", rig.air]
            batch.add("link", "add", outside, "type", "veth", *peer)
            batch.add("link", "set", outside, *plain)
        machine.return_to_air()
    numbers = [str(weather.delay_ms), str(weather.jitter_ms), str(weather.loss)]
    pairs = [f"{machine.name}:{machine.name}-air" for machine in machines]
    inside = ["ip", "netns", "exec", between, sys.executable, str(PROGRAMS / "relay.py")]
    relay = Program([*inside, *numbers, *pairs], PROGRAMS, {})
    rig.adopt(relay)
    relay.wait_for("relaying")
