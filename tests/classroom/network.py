"""Commands of `ip` and `tc`, in batches, and the processes of a network namespace."""

from __future__ import annotations

import os
import signal
import subprocess
import threading
import time
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable


def ip(*words: str, stdin: str | None = None) -> str:
    """Run `ip`; return what it printed."""
    return _run("ip", *words, stdin=stdin)


def tc(namespace: str, *words: str) -> str:
    """Run `tc` in a namespace; return what it printed."""
    return _run("tc", "-n", namespace, *words)


def _run(*words: str, stdin: str | None = None) -> str:
    done = subprocess.run(
        words, input=stdin, capture_output=True, encoding="utf-8", check=True, timeout=60
    )
    return done.stdout


class Batch:
    """Commands of `ip`, in one namespace or none, that run together at the end of the block."""

    def __init__(self, namespace: str | None = None) -> None:
        self._where = [] if namespace is None else ["-n", namespace]
        self._lines: list[str] = []

    def add(self, *words: str) -> None:
        self._lines.append(" ".join(words))

    def __enter__(self) -> Batch:
        return self

    def __exit__(self, kind: object, *_: object) -> None:
        if kind is None and self._lines:
            ip(*self._where, "-batch", "-", stdin="\n".join(self._lines) + "\n")


def namespaces() -> list[str]:
    """Return the names of all network namespaces."""
    return [line.split()[0] for line in ip("netns", "list").splitlines() if line]


def processes(namespace: str) -> set[int]:
    """Return the ids of the processes in a namespace."""
    return {int(pid) for pid in ip("netns", "pids", namespace).split()}


def end_processes(within: Iterable[str]) -> None:
    """Kill every process in some namespaces, and wait until they are gone."""
    names = list(within)
    pause = threading.Event()
    deadline = time.monotonic() + 30
    while found := {pid for name in names for pid in processes(name)}:
        if time.monotonic() > deadline:
            message = f"processes {found} survive SIGKILL"
            raise RuntimeError(message)
        for pid in found:
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                continue
        pause.wait(0.01)
