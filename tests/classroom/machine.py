"""Machine of the testbed: a network namespace with processes in it."""

from __future__ import annotations

import contextlib
import json
import os
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from tests.classroom.network import Batch, ip, processes, tc
from tests.conftest import Program, allowed

if TYPE_CHECKING:
    from collections.abc import Mapping

PROGRAMS = Path(__file__).parent / "programs"
_PREFIXES = ("ZBOT_", "ROS_", "RCUTILS_", "ZENOH_", "AMENT_", "COLCON_", "XDG_", "PYTEST_")
_OPEN_CLASS, _DROP_CLASS = "1:10", "1:66"


@dataclass(frozen=True)
class Traffic:
    """What an interface has carried since it exists."""

    received_bytes: int
    sent_bytes: int
    received_packets: int
    sent_packets: int

    def __sub__(self, earlier: Traffic) -> Traffic:
        return Traffic(
            self.received_bytes - earlier.received_bytes,
            self.sent_bytes - earlier.sent_bytes,
            self.received_packets - earlier.received_packets,
            self.sent_packets - earlier.sent_packets,
        )


@dataclass(frozen=True)
class Finished:
    """How a command ended, and how long it took, in seconds."""

    code: int
    out: str
    err: str
    took_s: float


class Started(Program):
    """A program in a machine; machines that start many at a time are slow."""

    def wait_for(self, text: str, timeout: float = 30.0) -> str:
        """Return the next line that contains `text`; fail if it does not come."""
        return super().wait_for(text, timeout)


class Machine:
    """A laptop, or the teacher's machine.

    Args:
        name: Its host name, and its port at the bridge.
        address: IPv4, in 10.77.0.0/16.
        namespace: Name of its network namespace.
        bridge: Name of the bridge's namespace.
        folder: For its home folder and the mount of its host name.
    """

    def __init__(self, name: str, address: str, namespace: str, bridge: str, folder: Path) -> None:
        self.name = name
        self.address = address
        self.namespace = namespace
        self.home = folder / "home"
        self._bridge = bridge
        self._uts = folder / "uts"
        self._gateway = ""
        self._isolated = True
        self._programs: list[Program] = []
        self._filters_traffic = False

    # -- building ------------------------------------------------------------------------------

    def add_cable(self, bridge: Batch) -> None:
        """Add its veth pair to a batch of the bridge's namespace."""
        peer = ("peer", "name", "eth0", "netns", self.namespace)
        bridge.add("link", "add", self.name, "type", "veth", *peer)

    def boot(self, gateway: str) -> None:
        """Give it a host name, a home folder, an address and a default route."""
        self._gateway = gateway
        self.home.mkdir(parents=True)
        self._uts.touch()
        subprocess.run(["unshare", f"--uts={self._uts}", "hostname", self.name], check=True)
        with Batch(self.namespace) as batch:
            batch.add("link", "set", "lo", "up")
            # No IPv6: its background packets would be counted in `traffic()`.
            batch.add("link", "set", "eth0", "addrgenmode", "none")
            batch.add("addr", "add", f"{self.address}/16", "dev", "eth0")
        self.plug_in()

    def connect_to_bridge(self, *, isolated: bool, multicast: bool = False) -> None:
        """Connect its port to the bridge; an isolated one reaches only those that are not."""
        self._isolated = isolated
        with Batch(self._bridge) as batch:
            batch.add("link", "set", self.name, "master", "br0")
            batch.add("link", "set", self.name, "addrgenmode", "none", "up")
            flood = "on" if multicast else "off"
            slave = f"isolated {'on' if isolated else 'off'} mcast_flood {flood}"
            batch.add("link", "set", self.name, "type", "bridge_slave", slave)

    # -- the network ---------------------------------------------------------------------------

    def unplug(self) -> None:
        """Take its interface down, as a closed lid does: the machine's system notices."""
        ip("-n", self.namespace, "link", "set", "eth0", "down")

    def plug_in(self) -> None:
        """Bring its interface up, with the default route that the system then sets."""
        with Batch(self.namespace) as batch:
            batch.add("link", "set", "eth0", "up")
            batch.add("route", "replace", "default", "via", self._gateway)

    def disconnect(self) -> None:
        """Drop all its packets, as out of reach of the Wi-Fi: its system does not notice."""
        ip("-n", self._bridge, "link", "set", self.name, "nomaster")

    def reconnect(self) -> None:
        """Undo `disconnect()`."""
        self.connect_to_bridge(isolated=self._isolated)

    def block_port(self, port: int) -> None:
        """Drop its packets to a TCP port, as a firewall does."""
        if not self._filters_traffic:
            # A traffic class with a blackhole needs neither nftables nor further kernel modules.
            self._add_class(_OPEN_CLASS)
            self._filters_traffic = True
        match = f"match ip protocol 6 0xff match ip dport {port} 0xffff".split()
        where = ["dev", "eth0", "parent", "1:", "protocol", "ip"]
        tc(self.namespace, "filter", "add", *where, "u32", *match, "flowid", _DROP_CLASS)

    def _add_class(self, default: str) -> None:
        root = ["dev", "eth0", "root", "handle", "1:", "htb", "default", default.split(":")[1]]
        tc(self.namespace, "qdisc", "add", *root)
        for name in (default, _DROP_CLASS):
            add = ["dev", "eth0", "parent", "1:", "classid", name, "htb", "rate", "1gbit"]
            tc(self.namespace, "class", "add", *add, "quantum", "60000")
        tc(self.namespace, "qdisc", "add", "dev", "eth0", "parent", _DROP_CLASS, "blackhole")

    def unblock_ports(self) -> None:
        """Undo every `block_port()`."""
        tc(self.namespace, "qdisc", "del", "dev", "eth0", "root")
        self._filters_traffic = False

    def traffic(self) -> Traffic:
        """Return what its interface has carried."""
        shown = ip("-n", self.namespace, "-s", "-j", "link", "show", "dev", "eth0")
        stats = json.loads(shown)[0]["stats64"]
        received, sent = stats["rx"], stats["tx"]
        return Traffic(received["bytes"], sent["bytes"], received["packets"], sent["packets"])

    # -- processes -----------------------------------------------------------------------------

    def start(self, *words: str, env: Mapping[str, str] | None = None) -> Program:
        """Start a program; it is killed, at the latest, with the testbed."""
        program = Started(self._command(words), self.home, self._environment(env))
        self._programs.append(program)
        return program

    def run(
        self, *words: str, timeout_s: float = 30, env: Mapping[str, str] | None = None
    ) -> Finished:
        """Run a program to its end."""
        begun = time.monotonic()
        done = subprocess.run(
            self._command(words),
            cwd=self.home,
            env=self._environment(env),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            encoding="utf-8",
            timeout=allowed(timeout_s),
            check=False,
        )
        return Finished(done.returncode, done.stdout, done.stderr, time.monotonic() - begun)

    def run_all(self, *commands: tuple[str, ...]) -> list[Finished]:
        """Run programs at the same time, each to its end."""
        with ThreadPoolExecutor(len(commands)) as pool:
            return list(pool.map(lambda words: self.run(*words), commands))

    def processes(self) -> set[int]:
        """Return the ids of all processes in it, also of those in the background."""
        return processes(self.namespace)

    def sleep(self) -> None:
        """Stop every process where it is, and the network with them, as closing the lid does."""
        self.unplug()
        self._signal(signal.SIGSTOP)

    def wake_up(self) -> None:
        """Undo `sleep()`."""
        self._signal(signal.SIGCONT)
        self.plug_in()

    def _signal(self, number: signal.Signals) -> None:
        for pid in self.processes():
            with contextlib.suppress(ProcessLookupError):  # it ended meanwhile
                os.kill(pid, number)

    def forget_programs(self) -> None:
        """Wait for the programs that were killed."""
        for program in self._programs:
            program.process.wait(5)

    def _command(self, words: tuple[str, ...]) -> list[str]:
        if words[0] == "zbot":
            words = (sys.executable, "-m", "zbot_cli", *words[1:])
        elif words[0].endswith(".py"):
            words = (sys.executable, str(PROGRAMS / words[0]), *words[1:])
        inside = ["nsenter", f"--net=/run/netns/{self.namespace}", f"--uts={self._uts}"]
        return [*inside, "--", *words]

    def _environment(self, more: Mapping[str, str] | None) -> dict[str, str]:
        kept = {name: value for name, value in os.environ.items() if not name.startswith(_PREFIXES)}
        own = {
            "HOME": str(self.home),
            "XDG_CONFIG_HOME": str(self.home / ".config"),
            "XDG_STATE_HOME": str(self.home / ".local" / "state"),
            "XDG_CACHE_HOME": str(self.home / ".cache"),
            "XDG_RUNTIME_DIR": str(self.home / ".run"),
            "PYTHONUNBUFFERED": "1",
            "ZBOT_NO_BROWSER": "1",
        }
        return {**kept, **own, **(more or {})}
