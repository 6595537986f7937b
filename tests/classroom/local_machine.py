"""Simulated machines: each has its own settings, hub port and domains. They need no root."""

from __future__ import annotations

import contextlib
import json
import os
import signal
import subprocess
import sys
from typing import TYPE_CHECKING, Any

import psutil

from tests.classroom.talk import free_port
from tests.cli.command import Outcome
from tests.conftest import allowed, wait_until

if TYPE_CHECKING:
    from pathlib import Path


class LocalMachine:
    """Simulated machine.

    Args:
        home: Its folder for settings.
    """

    def __init__(self, home: Path) -> None:
        self.home = home
        self.port = free_port()

    @property
    def environment(self) -> dict[str, str]:
        """What its programs find in their environment."""
        own = {"XDG_CONFIG_HOME": str(self.home), "ZBOT_HUB_PORT": str(self.port)}
        return {**os.environ, **own}

    def zbot(self, *words: str, stdin: str = "", timeout_s: float = 30, **more: str) -> Outcome:
        """Run a command to its end.

        Args:
            words: Behind `zbot`.
            stdin: What it reads.
            timeout_s: After which it is killed.
            more: Environment variables.
        """
        done = subprocess.run(
            [sys.executable, "-m", "zbot_cli", *words],
            env={**self.environment, **more},
            input=stdin,
            capture_output=True,
            encoding="utf-8",
            timeout=allowed(timeout_s),
            check=False,
        )
        assert "Traceback" not in done.stderr, done.stderr
        return Outcome(done.returncode, done.stdout, done.stderr)

    def succeed(self, *words: str, **options: Any) -> str:
        """Run a command that must not fail; return what it printed."""
        outcome = self.zbot(*words, **options)
        assert outcome.code == 0, outcome.err
        return outcome.out

    @property
    def has_joined(self) -> bool:
        """Whether it takes part in something."""
        return (self.folder() / "membership.json").exists()

    def kill_hub(self) -> None:
        """Kill its hub, as switching it off does; wait until that is so."""
        os.kill(self.hub_state()["pid"], getattr(signal, "SIGKILL", signal.SIGTERM))
        assert wait_until(lambda: not json.loads(self.succeed("status", "--json"))["hub"])

    def switch_off(self) -> None:
        """Kill its hub, and forget what it has joined. A test ends so faster than by leaving."""
        (self.folder() / "membership.json").unlink(missing_ok=True)
        with contextlib.suppress(FileNotFoundError, psutil.NoSuchProcess):
            hub = psutil.Process(self.hub_state()["pid"])
            if "zbot.classroom" in hub.cmdline():
                hub.kill()

    def hub_state(self) -> dict[str, Any]:
        """Return the process id of its hub, when the hub was opened, and so on."""
        state: dict[str, Any] = json.loads((self.folder() / "hub.json").read_text())
        return state

    def folder(self) -> Path:
        """Return its settings."""
        return self.home / "zbot"
