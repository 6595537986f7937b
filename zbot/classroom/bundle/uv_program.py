"""Program uv: it finds the packages that another system and Python need, and builds wheels.

pip is not suitable: it judges the markers of requirements, e.g. `sys_platform == "win32"`, for the
machine on which it runs.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from importlib import import_module
from importlib.util import find_spec

from zbot.classroom.bundle.errors import BundleError
from zbot.errors.installation import pip_install

_FETCH = re.compile(
    r"failed to fetch|error sending request|could not connect|dns error", re.IGNORECASE
)
_CAUSE = re.compile(r"^\s*(?:╰─▶|cause(?:d by)?:)\s*(.+)", re.IGNORECASE | re.MULTILINE)


class NoAnswerError(BundleError):
    """uv found no solution. `reason` is its first sentence."""

    def __init__(self, reason: str) -> None:
        self.reason = reason
        super().__init__(reason)


def find_uv() -> str:
    """Return the path of uv.

    Raises:
        BundleError: uv or packaging is not installed.
    """
    if find_spec("packaging") and find_spec("uv"):
        return str(import_module("uv").find_uv_bin())
    found = shutil.which("uv") if find_spec("packaging") else None
    if found is None:
        raise BundleError(f"a bundle needs uv: {pip_install('zbot[bundle]')}")
    return found


def run_uv(*words: str, text: str = "", variables: dict[str, str] | None = None) -> str:
    """Run uv, and return its standard output.

    Args:
        words: The words of the command line.
        text: The standard input.
        variables: Further environment variables.

    Raises:
        NoAnswerError: No packages fit.
        BundleError: uv is not there, or the package index cannot be reached.
    """
    done = subprocess.run(  # noqa: S603 - uv and our own words
        [find_uv(), *words, "--no-progress", "--color", "never"],
        input=text,
        capture_output=True,
        encoding="utf-8",
        env={**os.environ, **_index(), **(variables or {})},
        check=False,
    )
    if done.returncode == 0:
        return done.stdout
    if _FETCH.search(done.stderr):
        raise BundleError(
            f"the package index cannot be reached ({_cause(done.stderr)}): "
            "check the internet connection of this machine"
        )
    raise NoAnswerError(_cause(done.stderr))


def _cause(said: str) -> str:
    """Return one line with the reason in what uv said."""
    causes = _CAUSE.findall(said) or [line for line in said.splitlines() if line.strip()]
    line = " ".join(said[said.find(causes[-1]) :].split()) if causes else "uv gave no reason"
    first = re.split(r"(?<=[a-z`)])\.(?:\s|$)|, we can conclude|\s(?:╰─▶|hint:)", line)[0]
    return first.removeprefix("Because ")[:300]


def _index() -> dict[str, str]:
    """Return pip's own package index for uv, which reads no settings of pip."""
    if any(os.environ.get(name) for name in ("UV_INDEX_URL", "UV_DEFAULT_INDEX", "UV_NO_INDEX")):
        return {}
    done = subprocess.run(
        [sys.executable, "-m", "pip", "config", "list"],
        capture_output=True,
        encoding="utf-8",
        errors="replace",
        check=False,
    )
    found = re.search(r"\.index-url='([^']+)'", done.stdout)
    return {"UV_DEFAULT_INDEX": found[1]} if found else {}
