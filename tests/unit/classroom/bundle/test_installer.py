"""Program `install.py` of a bundle, without the step in which pip installs."""

from __future__ import annotations

import shutil
import subprocess
import sys
from typing import TYPE_CHECKING

import pytest

from zbot.classroom.bundle import installer, manifest
from zbot.classroom.bundle.manifest import Manifest

if TYPE_CHECKING:
    from pathlib import Path

_WHEELS = ("pip-26.0-py3-none-any.whl", "zbot-0.1.0-py3-none-any.whl")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    usb = tmp_path / "usb"
    (usb / "wheels").mkdir(parents=True)
    for name in _WHEELS:
        (usb / "wheels" / name).write_bytes(b"no wheel")
    shutil.copy(installer.__file__, usb / "install.py")
    save(usb, installer.this_target())
    return usb


def save(usb: Path, target: str) -> None:
    files = manifest.digests(usb, [f"wheels/{name}" for name in _WHEELS])
    Manifest("0.1.0", [], {target: {"extras": ["web"], "wheels": list(_WHEELS)}}, files).save(usb)


def install(usb: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, usb / "install.py", "--to", usb.parent / "env"],
        capture_output=True,
        text=True,
        check=False,
    )


def test_a_flipped_byte_is_refused_by_name(folder: Path) -> None:
    (folder / "wheels" / _WHEELS[1]).write_bytes(b"no whe3l")
    done = install(folder)
    assert done.returncode == 1
    assert f"{_WHEELS[1]} is damaged" in done.stderr
    assert done.stderr.count("\n") == 1
    assert not (folder.parent / "env").exists()


def test_a_missing_file_is_named(folder: Path) -> None:
    (folder / "wheels" / _WHEELS[0]).unlink()
    assert f"{_WHEELS[0]} is missing" in install(folder).stderr


def test_each_step_is_said_and_an_error_of_pip_is_the_end(folder: Path) -> None:
    done = install(folder)
    assert done.returncode == 1
    assert [line[0] for line in done.stdout.splitlines()] == ["1", "2", "3"]
    assert "error: pip did not install zbot" in done.stderr


def test_a_python_that_the_bundle_does_not_have_is_named(folder: Path) -> None:
    save(folder, "amiga-m68k-3.13")
    done = install(folder)
    assert done.returncode == 1
    assert f"this Python is {installer.this_target()}; the bundle has no Python for" in done.stderr


def test_the_requirements_have_hashes() -> None:
    lines = installer.requirement_lines({"wheels/typing_extensions-4.1-py3-none-any.whl": "ab"})
    assert lines == "typing_extensions==4.1 --hash=sha256:ab\n"
