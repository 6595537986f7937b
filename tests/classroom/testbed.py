"""Testbed: a classroom on one machine, with a network namespace for each laptop.

Each laptop has its own loopback, host name and home folder, and a veth pair to a bridge. The ports
of the bridge are isolated from each other, except the teacher's, and pass no multicast, like an
access point with client isolation. Needs root and iproute2 (see `missing_requirement()`).
"""

from __future__ import annotations

import functools
import itertools
import os
import shutil
import subprocess
from pathlib import Path
from typing import TYPE_CHECKING

from tests.classroom.machine import Machine
from tests.classroom.network import Batch, end_processes, ip, namespaces

if TYPE_CHECKING:
    from tests.conftest import Program

_RUN = Path("/run/zbot-testbed")  # mounts of host names, and the machines' home folders
_NUMBER = itertools.count()
_TOOLS = ("ip", "tc", "nsenter", "unshare", "hostname")
_GATEWAY = "10.77.255.254"


@functools.cache
def missing_requirement() -> str | None:
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


class LanTestbed:
    """A teacher's machine, some laptops, and the bridge between them.

    Args:
        laptops: How many; their addresses are 10.77.1.1, 10.77.1.2, ...

    Use it as a context manager, which kills every process in it and removes everything at its end.
    The next testbed removes what a killed test run has left.
    """

    def __init__(self, laptops: int) -> None:
        remove_old_testbeds()
        self._name = f"zbot-{os.getpid()}-{next(_NUMBER)}"
        self._folder = _RUN / self._name
        self.bridge = f"{self._name}-bridge"
        self._programs: list[Program] = []
        self.teacher = self._machine("teacher", "10.77.0.1")
        self.laptops = [
            self._machine(f"laptop{number}", f"10.77.{1 + number // 200}.{1 + number % 200}")
            for number in range(laptops)
        ]

    def _machine(self, name: str, address: str) -> Machine:
        namespace = f"{self._name}-{name}"
        return Machine(name, address, namespace, self.bridge, self._folder / name)

    @property
    def machines(self) -> list[Machine]:
        """The teacher's machine and the laptops."""
        return [self.teacher, *self.laptops]

    def __enter__(self) -> LanTestbed:
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
            for name in (self.bridge, *(machine.namespace for machine in self.machines)):
                batch.add("netns", "add", name)
        with Batch(self.bridge) as batch:
            batch.add("link", "add", "br0", "type", "bridge")
            batch.add("link", "set", "br0", "addrgenmode", "none", "up")
            batch.add("addr", "add", f"{_GATEWAY}/16", "dev", "br0")
            for machine in self.machines:
                machine.add_cable(batch)
        for machine in self.machines:
            machine.boot(_GATEWAY)
            machine.connect_to_bridge(isolated=machine is not self.teacher)

    def add_namespace(self, name: str) -> str:
        """Add a namespace that ends with the testbed; return its full name."""
        namespace = f"{self._name}-{name}"
        ip("netns", "add", namespace)
        return namespace

    def adopt(self, program: Program) -> None:
        """Wait for a program, too, when everything in the testbed was killed."""
        self._programs.append(program)

    def _remove(self) -> None:
        _remove_testbed(self._name)
        for program in self._programs:
            program.process.wait(5)
        for machine in self.machines:
            machine.forget_programs()


def remove_old_testbeds() -> None:
    """Remove the rigs of test runs that were killed."""
    if not _RUN.is_dir():
        return
    for folder in _RUN.iterdir():
        owner = folder.name.split("-")[1]
        if not Path("/proc", owner).exists():
            _remove_testbed(folder.name)


def _remove_testbed(name: str) -> None:
    mine = [namespace for namespace in namespaces() if namespace.startswith(f"{name}-")]
    end_processes(mine)
    with Batch() as batch:
        for namespace in mine:
            batch.add("netns", "del", namespace)
    folder = _RUN / name
    for mount in folder.glob("*/uts"):
        subprocess.run(["umount", str(mount)], check=False, capture_output=True)
    shutil.rmtree(folder, ignore_errors=True)
