"""Function that runs `zbot` in a process of its own and returns exit code and output."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import dataclass
from typing import TYPE_CHECKING

from tests.conftest import allowed

if TYPE_CHECKING:
    from pathlib import Path


@dataclass(frozen=True)
class Outcome:
    """Exit code and output of a command."""

    code: int
    out: str
    err: str


def zbot(*words: str, stdin: str = "", cwd: Path | None = None, timeout_s: float = 30) -> Outcome:
    """Run a command line; fail if it prints a traceback."""
    done = subprocess.run(
        [sys.executable, "-m", "zbot_cli", *words],
        input=stdin,
        capture_output=True,
        encoding="utf-8",
        timeout=allowed(timeout_s),
        cwd=cwd,
        check=False,
    )
    assert "Traceback" not in done.stderr, done.stderr
    return Outcome(done.returncode, done.stdout, done.stderr)
