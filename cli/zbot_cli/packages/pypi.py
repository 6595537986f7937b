"""Downloader of packages from the Python package index, by pip or uv."""

from __future__ import annotations

import importlib.util
import re
import shutil
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

from zbot_cli.errors import CommandError

if TYPE_CHECKING:
    from collections.abc import Iterator

_NAME = re.compile(r"[A-Za-z0-9]([A-Za-z0-9._-]*[A-Za-z0-9])?(==[A-Za-z0-9.!+_-]+)?")
#: Word that pip and uv print before the reason of an error.
_PREFIX = re.compile(r"^\s*(ERROR|error|cause): ")


def download_error(name: str, reason: str) -> CommandError:
    """Return the error that a package cannot be downloaded."""
    return CommandError(f"cannot download {name}: {reason}")


def is_name(word: str) -> bool:
    """Return whether a word can be the name of a package, with or without `==VERSION`."""
    return bool(_NAME.fullmatch(word))


@contextmanager
def downloaded(name: str) -> Iterator[Path]:
    """Download a package, yield the path of its wheel, and delete the wheel afterwards.

    If uv is used, the path is a folder with the files of the wheel. Only wheels are downloaded,
    because pip would run programs of a source archive to read its name.

    Raises:
        CommandError: Neither pip nor uv is installed, or there is no such wheel.
    """
    with TemporaryDirectory(prefix="zbot-") as folder:
        command = [*_command(name), folder, name]
        result = subprocess.run(  # noqa: S603 - the name has the form of a package's name
            command, capture_output=True, text=True, errors="replace", check=False
        )
        wheels = sorted(Path(folder).glob("*.whl"))
        if result.returncode:
            lines = [line for line in result.stderr.splitlines() if line.strip()] or [
                "no such wheel"
            ]
            raise download_error(name, _PREFIX.sub("", lines[-1]))
        yield wheels[0] if wheels else Path(folder)


def _command(name: str) -> list[str]:
    """Return the command that downloads a wheel. A folder and the package's name must follow."""
    if importlib.util.find_spec("pip") is not None:
        options = ["--no-deps", "--only-binary=:all:", "--disable-pip-version-check", "--quiet"]
        return [sys.executable, "-m", "pip", "download", *options, "--dest"]
    program = shutil.which("uv")  # environments that uv has made have no pip
    if program is None:
        raise download_error(name, "neither pip nor uv is installed; download the file yourself")
    options = ["--no-deps", "--no-build", "--quiet", "--python", sys.executable]
    return [program, "pip", "install", *options, "--target"]
