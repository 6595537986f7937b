"""A classroom on one machine: a network namespace for each laptop, and Wi-Fi as schools have it.

Every laptop is a veth pair away from a bridge, in a namespace of its own with its own loopback,
host name and home folder. The bridge's ports are isolated from each other (an access point's
"client isolation"), all but the teacher's, and none passes multicast. Needs root and iproute2:
`obstacle()` says what is missing.
"""

from __future__ import annotations

import functools
import itertools
import os
import shutil
import subprocess
import time
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from tests.classroom.machine import Machine
from tests.classroom.network import Batch, end_processes, ip, namespaces

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tests.conftest import Program

_RUN = Path("/run/zbot-rig")  # mounts of host names, and the machines' home folders
_NUMBER = itertools.count()
_TOOLS = ("ip", "tc", "nsenter", "unshare", "hostname")
_GATEWAY = "10.77.255.254"


@functools.cache
def obstacle() -> str | None:
    """Return why no classroom can be built here, or `None`."""
    if not hasattr(os, "geteuid") or os.geteuid() != 0:
        return "network namespaces need root"
    missing = [tool for tool in _TOOLS if shutil.which(tool) is None]
    if missing:
        return f"network namespaces need {', '.join(missing)} (iproute2 and util-linux)"
    probe = f"zbot-{os.getpid()}-probe"
    try:
        ip("netns", "add", probe)
        try:
            ip("-n", probe, "link", "add", "here", "type", "veth", "peer", "name", "there")
        finally:
            ip("netns", "del", probe)
    except subprocess.CalledProcessError as exc:
        return f"the system refuses network namespaces: {exc.stderr.strip()}"
    return None


class Rig:
    """A teacher's machine, some laptops, and the air between them.

    Args:
        laptops: How many; their addresses are 10.77.1.1, 10.77.1.2, ...

    Use it as a context manager: at its end every process in it is killed and nothing is left. What
    a killed test run left behind, the next rig removes.
    """

    def __init__(self, laptops: int) -> None:
        remove_leftovers()
        self._name = f"zbot-{os.getpid()}-{next(_NUMBER)}"
        self._folder = _RUN / self._name
        self.air = f"{self._name}-air"
        self._programs: list[Program] = []
        self.teacher = self._machine("teacher", "10.77.0.1")
        self.laptops = [
            self._machine(f"laptop{number}", f"10.77.{1 + number // 200}.{1 + number % 200}")
            for number in range(laptops)
        ]

    def _machine(self, name: str, address: str) -> Machine:
        namespace = f"{self._name}-{name}"
        return Machine(name, address, namespace, self.air, self._folder / name)

    @property
    def machines(self) -> list[Machine]:
        """The teacher's machine and the laptops."""
        return [self.teacher, *self.laptops]

    def __enter__(self) -> Rig:
        try:
            self._build()
        except BaseException:
            self._remove()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        self._remove()

    def _build(self) -> None:
        with Batch() as batch:
            for name in (self.air, *(machine.namespace for machine in self.machines)):
                batch.add("netns", "add", name)
        with Batch(self.air) as batch:
            batch.add("link", "add", "br0", "type", "bridge")
            batch.add("link", "set", "br0", "addrgenmode", "none", "up")
            batch.add("addr", "add", f"{_GATEWAY}/16", "dev", "br0")
            for machine in self.machines:
                machine.wire(batch)
        for machine in self.machines:
            machine.boot(_GATEWAY)
            machine.join_air(isolated=machine is not self.teacher)

    def add_namespace(self, name: str) -> str:
        """Add a namespace that ends with the rig; return its full name."""
        namespace = f"{self._name}-{name}"
        ip("netns", "add", namespace)
        return namespace

    def adopt(self, program: Program) -> None:
        """Wait for a program, too, when everything in the rig was killed."""
        self._programs.append(program)

    def _remove(self) -> None:
        _remove_rig(self._name)
        for program in self._programs:
            program.process.wait(5)
        for machine in self.machines:
            machine.forget_programs()


def remove_leftovers() -> None:
    """Remove the rigs of test runs that were killed."""
    if not _RUN.is_dir():
        return
    for folder in _RUN.iterdir():
        owner = folder.name.split("-")[1]
        if not Path("/proc", owner).exists():
            _remove_rig(folder.name)


def _remove_rig(name: str) -> None:
    mine = [one for one in namespaces() if one.startswith(f"{name}-")]
    end_processes(mine)
    with Batch() as batch:
        for namespace in mine:
            batch.add("netns", "del", namespace)
    folder = _RUN / name
    for mount in folder.glob("*/uts"):
        subprocess.run(["umount", str(mount)], check=False, capture_output=True)
    shutil.rmtree(folder, ignore_errors=True)


@contextmanager
def stopwatch() -> Iterator[list[float]]:
    """Put the seconds that the block took into the list that it gets."""
    took: list[float] = []
    begun = time.monotonic()
    yield took
    took.append(time.monotonic() - begun)
