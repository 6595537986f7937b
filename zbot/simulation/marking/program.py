"""Program that is marked: a process whose output is kept, and that ends with its children."""

from __future__ import annotations

import contextlib
import os
import re
import signal
import subprocess
import sys
import threading
from pathlib import Path

from zbot.text.terminal import escape_control_characters

_END_S = 2.0
_MOST_OUTPUT = 200_000
_TAIL = 8_000
_MOST_REASON = 200
LAUNCH_ENDINGS = (".launch.py", ".launch.xml", ".launch.yaml", ".launch.yml")
_LAUNCH = (sys.executable, "-m", "zbot_cli", "launch")
_IN_WORLD_TIME = Path(__file__).with_name("in_world_time.launch.xml")


def is_launch_file(path: Path) -> bool:
    """Return whether a file is a launch file."""
    return path.name.endswith(LAUNCH_ENDINGS)


def _command(path: Path) -> list[str]:
    if is_launch_file(path):
        return [*_LAUNCH, str(_IN_WORLD_TIME), f"file:={path}"]
    return [sys.executable, path.name, "--ros-args", "-p", "use_sim_time:=true"]


class MarkedProgram:
    """Process of a program that follows the time of a simulator.

    Args:
        path: The file of the program, or a launch file.
        environment: Its environment.
    """

    def __init__(self, path: Path, environment: dict[str, str]) -> None:
        self._path = path
        self._begin, self._tail, self._left_out = b"", b"", 0
        # The order of a set of texts depends on this number.
        environment = {**environment, "PYTHONHASHSEED": "0", "PYTHONUNBUFFERED": "1"}
        self._process = subprocess.Popen(  # noqa: S603 - the teacher names the program
            _command(path),
            cwd=path.parent,
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            start_new_session=os.name != "nt",
        )
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self) -> None:
        """Read all output, also if it is endless. Keep its beginning and its end."""
        assert self._process.stdout is not None
        with self._process.stdout as pipe:
            while part := os.read(pipe.fileno(), 65536):
                kept = part[: _MOST_OUTPUT - len(self._begin)]
                self._begin += kept
                rest = self._tail + part[len(kept) :]
                self._left_out += max(0, len(rest) - _TAIL)
                self._tail = rest[-_TAIL:]

    @property
    def output(self) -> str:
        """What the program has printed."""
        gap = f"\n... {self._left_out} bytes are left out ...\n".encode() if self._left_out else b""
        return (self._begin + gap + self._tail).decode(errors="replace")

    @property
    def has_ended(self) -> bool:
        """Whether the process has ended."""
        return self._process.poll() is not None

    @property
    def failure(self) -> str:
        """Why the program has ended by itself with an error. Empty if it has not."""
        code = self._process.poll()
        if not code:
            return ""
        self._reader.join(_END_S)
        if code < 0:
            with contextlib.suppress(ValueError):
                return f"the program was ended by {signal.Signals(-code).name}"
        return f"the program ended with {self._last_error() or f'the exit code {code}'}"

    def _last_error(self) -> str:
        """Return the last line of a traceback, and the number of the program's line in it."""
        lines = self.output.splitlines()
        if not any(line.startswith(("Traceback (", '  File "')) for line in lines):
            return ""
        error = next(
            (line for line in reversed(lines) if re.match(r"[A-Za-z_][\w.]*(:|$)", line)), ""
        )
        name = re.escape(self._path.name)
        places = [re.search(rf'File ".*{name}", line (\d+)', line) for line in lines]
        where = next((f", in line {found[1]}" for found in reversed(places) if found), "")
        return escape_control_characters(error[:_MOST_REASON]) + where if error else ""

    def end(self) -> None:
        """End the process and its children."""
        self._signal(signal.SIGTERM)
        with contextlib.suppress(subprocess.TimeoutExpired):
            self._process.wait(_END_S)
        # Children may live on, and a program may ignore the first signal.
        if sys.platform != "win32":
            self._signal(signal.SIGKILL)
        self._process.wait()
        self._reader.join(_END_S)

    def _signal(self, number: int) -> None:
        if sys.platform == "win32":
            self._process.terminate()
            return
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(self._process.pid, number)
