"""Class that serves a bundle, from which laptops without the internet install."""

from __future__ import annotations

import contextlib
import json
import shlex
import subprocess
import sys
import urllib.request
from importlib.util import find_spec
from typing import TYPE_CHECKING

import pytest

from tests.conftest import wait_until
from tests.unit.classroom.bundle.index import write_wheel
from zbot.classroom.bundle import manifest
from zbot.classroom.bundle.first_page import first_page
from zbot.classroom.bundle.manifest import Manifest

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from tests.classroom.local_machine import LocalMachine

_WHEEL = "wheels/zbot-9.9.9-py3-none-any.whl"


@pytest.fixture
def teacher(make_machine: Callable[[str], LocalMachine]) -> LocalMachine:
    return make_machine("teacher")


@pytest.fixture
def usb(tmp_path: Path) -> Path:
    """Return a bundle with a wheel that has the name of zbot and no content."""
    folder = tmp_path / "usb"
    write_wheel(folder / "wheels", _WHEEL.rpartition("/")[2], extras=["web"])
    files = manifest.digests(folder, [_WHEEL])
    (folder / "index.html").write_text(first_page("9.9.9", files))
    digests = files | manifest.digests(folder, ["index.html"])
    Manifest("9.9.9", ["web"], {}, digests).save(folder)
    return folder


def answers(address: str) -> bool:
    with contextlib.suppress(OSError), urllib.request.urlopen(address, timeout=5) as answer:
        return bool(answer.status == 200)
    return False


@pytest.mark.skipif(find_spec("pip") is None, reason="the line of the teacher needs pip")
def test_the_line_of_the_teacher_installs_until_the_class_is_closed(
    teacher: LocalMachine, usb: Path, tmp_path: Path
) -> None:
    told = teacher.succeed("class", "start", "--bundle", str(usb))
    lines = [line.strip() for line in told.splitlines()]
    line = next(line for line in lines if line.startswith("python3 -m pip install --no-index "))
    assert line.replace("python3", "py", 1) == next(
        line for line in lines if line.startswith("py ")
    )
    words = shlex.split(line)
    assert words[-1] == "zbot[web]"
    done = subprocess.run(
        [sys.executable, *words[1:], "--target", tmp_path / "laptop"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "laptop" / "zbot.py").exists()
    shown = json.loads(teacher.succeed("class", "start", "--json"))["bundle"]
    assert shown["others"] == line
    assert answers(shown["address"])
    teacher.succeed("class", "stop")
    assert wait_until(lambda: not answers(shown["address"]))


def test_a_damaged_bundle_is_refused_before_the_class_is_opened(
    teacher: LocalMachine, usb: Path
) -> None:
    (usb / _WHEEL).write_bytes(b"damaged")
    outcome = teacher.zbot("class", "start", "--bundle", str(usb))
    assert outcome.code == 1
    assert f"{usb / _WHEEL}: missing, or damaged" in outcome.err
    assert outcome.err.count("\n") == 1
    assert not teacher.has_joined
