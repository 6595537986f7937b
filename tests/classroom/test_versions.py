"""Laptops and programs that have different versions of zbot."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from tests.classroom.talk import HERE
from tests.conftest import wait_until
from zbot.version import __version__

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from tests.classroom.local_machine import LocalMachine
    from tests.conftest import Start

_DIFFERENCE = f"has 9.9.9, and this machine has {__version__}. Install one version everywhere\n"


@pytest.fixture
def newer(tmp_path: Path) -> str:
    """Return a value of PYTHONPATH with which zbot has a newer version."""
    folder = tmp_path / "newer"
    folder.mkdir()
    (folder / "sitecustomize.py").write_text(
        "import zbot.version\n\nzbot.version.__version__ = '9.9.9'\n"
    )
    return str(folder)


def test_a_laptop_and_a_teacher_with_other_versions_say_so(
    make_machine: Callable[[str], LocalMachine], newer: str
) -> None:
    teacher, ana, ben = make_machine("teacher"), make_machine("Ana"), make_machine("Ben")
    teacher.succeed("class", "start", "Robots")
    address = f"{HERE}:{teacher.port}"
    assert "versions" not in ana.zbot("join", address, "--name", "Ana").err
    joined = ben.zbot("join", address, "--name", "Ben", PYTHONPATH=newer)
    assert joined.code == 0
    assert joined.err == (
        f'zbot has different versions: the class "Robots" has {__version__}, and this machine has '
        "9.9.9. Install one version everywhere\n"
    )
    text = f"zbot has different versions: Ben (number 2) {_DIFFERENCE}"
    assert wait_until(lambda: text in teacher.succeed("class", "list"))


def test_a_machine_and_a_hub_with_other_versions_say_so(
    make_machine: Callable[[str], LocalMachine], newer: str, start: Start
) -> None:
    hub, other = make_machine("hub"), make_machine("other")
    listen = f"{HERE}:{hub.port}"
    start("zbot", "hub", "--listen", listen, env=hub.environment).wait_for("zbot join")
    joined = other.zbot("join", listen, PYTHONPATH=newer)
    assert joined.code == 0
    assert f"zbot has different versions: {HERE} has {__version__}, and this machine" in joined.err
