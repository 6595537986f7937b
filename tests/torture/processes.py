"""Processes of a run in a domain of its own, all of which end with the run, whatever happens.

All processes have a variable with the run's name in their environment. Processes that these have
started, such as the router of the domain, have it too, and so they are found and ended.
"""

from __future__ import annotations

import contextlib
import json
import os
import re
import signal
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tests.conftest import allowed, wait_until

if TYPE_CHECKING:
    from collections.abc import Iterator

PROGRAMS = Path(__file__).parent / "programs"
ROOT = Path(__file__).parents[2]
_VARIABLE = "ZBOT_TORTURE_RUN"
_PREFIXES = ("ZBOT_", "ROS_", "RCUTILS_", "ZENOH_", "AMENT_", "COLCON_", "XDG_")
_PAUSE_S = 0.01
_FAULTS = (
    *("Traceback (most recent call last)", "panicked at", "Fatal Python error", "Segmentation"),
    *("core dumped", "Exception ignored in"),
)


class Process:
    """Process whose output is in a file.

    Args:
        name: Name in the report.
        words: The command.
        environment: All variables.
        output: The file.
    """

    def __init__(
        self, name: str, words: list[str], environment: dict[str, str], output: Path
    ) -> None:
        self.name, self.output = name, output
        self.started = time.monotonic()
        with output.open("wb") as file:
            self._process = subprocess.Popen(
                words,
                env=environment,
                stdin=subprocess.DEVNULL,
                stdout=file,
                stderr=subprocess.STDOUT,
                start_new_session=True,  # Ctrl-C ends the run, and the run ends its processes
            )
        self.pid = self._process.pid

    @property
    def exit_code(self) -> int | None:
        """Its exit code, or None while it runs."""
        return self._process.poll()

    def signal(self, number: int) -> None:
        """Send a signal. Nothing happens after the end."""
        self._process.send_signal(number)

    def wait(self, timeout_s: float) -> int | None:
        """Wait for the end. Return the exit code, or None after `allowed(timeout_s)`."""
        with contextlib.suppress(subprocess.TimeoutExpired):
            return self._process.wait(allowed(timeout_s))
        return None

    def text(self) -> str:
        """Return its output until now."""
        return self.output.read_text(encoding="utf-8", errors="replace")

    def facts(self, kind: str = "") -> list[dict[str, Any]]:
        """Return its lines of JSON, all or those of a kind."""
        found = []
        for line in self.text().splitlines():
            with contextlib.suppress(ValueError):
                facts = json.loads(line)
                if isinstance(facts, dict) and (not kind or facts.get("kind") == kind):
                    found.append(facts)
        return found

    def last_fact(self) -> dict[str, Any]:
        """Return its last complete line of JSON; empty if there is none."""
        with self.output.open("rb") as file:
            file.seek(0, os.SEEK_END)
            file.seek(max(0, file.tell() - 65_536))
            lines = file.read().decode(errors="replace").split("\n")[:-1]
        with contextlib.suppress(ValueError, IndexError):
            found: dict[str, Any] = json.loads(lines[-1])
            return found
        return {}

    def wait_for(self, kind: str, timeout_s: float) -> dict[str, Any] | None:
        """Wait for a line of a kind. Return None after `allowed(timeout_s)` or at the end."""
        wait_until(lambda: bool(self.facts(kind)) or self.exit_code is not None, timeout_s)
        return next(iter(self.facts(kind)), None)

    def faults(self) -> list[str]:
        """Return the lines of its output that tell of a crash, with the name of the file."""
        return [
            f"{self.output}:{number}: {line.strip()}"
            for number, line in enumerate(self.text().splitlines(), 1)
            if any(fault in line for fault in _FAULTS)
        ]

    def usage(self) -> tuple[int, int]:
        """Return its memory in bytes and its number of descriptors; zeros after its end."""
        folder = Path(f"/proc/{self.pid}")
        with contextlib.suppress(OSError, IndexError):
            pages = int((folder / "statm").read_text(encoding="ascii").split()[1])
            return pages * os.sysconf("SC_PAGE_SIZE"), len(list((folder / "fd").iterdir()))
        return 0, 0

    def descriptors(self) -> str:
        """Return how many descriptors it has of each kind, e.g. `13 socket, 2 .zenoh`."""
        kinds = Counter[str]()
        for descriptor in Path(f"/proc/{self.pid}/fd").iterdir():
            with contextlib.suppress(OSError):  # it was closed meanwhile
                target = descriptor.readlink()
                kinds[target.suffix or target.name.partition(":")[0]] += 1
        return ", ".join(f"{count} {kind}" for kind, count in kinds.most_common())

    def threads(self) -> int:
        """Return its number of threads; 0 after its end."""
        with contextlib.suppress(OSError):
            return len(list(Path(f"/proc/{self.pid}/task").iterdir()))
        return 0


class Processes:
    """Processes of a run. All of them end with the block, also those in the background.

    Args:
        folder: An empty folder for their output and their settings.
        domain: The domain of the run.
    """

    def __init__(self, folder: Path, domain: int) -> None:
        self.folder, self.domain = folder, domain
        self.settings = folder / "settings"
        self.settings.mkdir()
        self.all: list[Process] = []
        self._run = f"{os.getpid()}-{time.time_ns()}"

    def environment(self, **more: str) -> dict[str, str]:
        """Return the variables of a process of this run."""
        kept = {name: value for name, value in os.environ.items() if not name.startswith(_PREFIXES)}
        path = os.pathsep.join(str(ROOT / folder) for folder in ("", "cli", "nodes"))
        own = {
            _VARIABLE: self._run,
            "PYTHONPATH": path,
            "PYTHONUNBUFFERED": "1",
            "XDG_CONFIG_HOME": str(self.settings),
            "ZBOT_DOMAIN_ID": str(self.domain),
            "ZBOT_HUB_PORT": "9",
            "ZBOT_NO_BROWSER": "1",
        }
        return {**kept, **own, **more}

    def start(self, name: str, *words: str, **more: str) -> Process:
        """Start a program: `x.py` is one of the folder `programs`, and `zbot` is the command."""
        if words[0] == "zbot":
            words = (sys.executable, "-m", "zbot_cli", *words[1:])
        elif words[0].endswith(".py"):
            words = (sys.executable, str(PROGRAMS / words[0]), *words[1:])
        output = self.folder / f"{len(self.all):05d}-{name}.log"
        process = Process(name, list(words), self.environment(**more), output)
        self.all.append(process)
        return process

    def ids(self) -> set[int]:
        """Return the ids of all processes of this run that exist."""
        mark = f"{_VARIABLE}={self._run}".encode()
        found = set()
        for path in Path("/proc").glob("[0-9]*/environ"):
            with contextlib.suppress(OSError):
                if mark in path.read_bytes().split(b"\0"):
                    found.add(int(path.parent.name))
        return found

    def faults(self) -> list[str]:
        """Return what the outputs say of crashes, with the names of their files."""
        return [fault for process in self.all for fault in process.faults()]

    def __enter__(self) -> Processes:
        return self

    def __exit__(self, *_: object) -> None:
        deadline = time.monotonic() + 10
        while (ids := self.ids()) and time.monotonic() < deadline:
            for number in ids:
                with contextlib.suppress(ProcessLookupError):
                    os.kill(number, signal.SIGKILL)
            for process in self.all:
                process.wait(0 if process.pid not in ids else 5)
            time.sleep(_PAUSE_S)


def memory_mb(pid: int) -> float:
    """Return a process's memory, without the 16 MiB of shared memory for large messages."""
    text = Path(f"/proc/{pid}/status").read_text(encoding="ascii")
    parts = re.findall(r"^Rss(?:Anon|File):\s+(\d+) kB", text, re.MULTILINE)
    return sum(map(int, parts)) * 1024 / 1e6


def forget_most_memory(pid: int) -> None:
    """Let `most_memory_mb` of a process begin anew."""
    Path(f"/proc/{pid}/clear_refs").write_text("5", encoding="utf-8")


def most_memory_mb(pid: int) -> float:
    """Return the largest memory of a process since `forget_most_memory`, in MB."""
    found = re.search(r"VmHWM:\s+(\d+)", Path(f"/proc/{pid}/status").read_text(encoding="utf-8"))
    assert found is not None, f"process {pid} has ended"
    return int(found[1]) * 1024 / 1e6


@contextlib.contextmanager
def clean_end() -> Iterator[None]:
    """Let SIGTERM and SIGHUP end the block as Ctrl-C does, so that everything is cleaned up.

    Ctrl-C works also in a program that a shell has started in the background with SIGINT ignored.
    """

    def end(*_: object) -> None:
        raise KeyboardInterrupt

    signals = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
    before = {number: signal.signal(number, end) for number in signals}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
