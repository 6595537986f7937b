"""Tests of the page that turtlesim opens in the browser of this machine."""

from __future__ import annotations

import os
import sys
import urllib.request
from typing import TYPE_CHECKING

import pytest

from tests.conftest import wait_until

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import Start

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="a browser is chosen otherwise")

RUN = ("zbot", "run", "turtlesim", "turtlesim_node")
HINT = 'pip install "zbot[web]"'


@pytest.fixture
def address_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the file with the addresses that were opened in the browser."""
    addresses = tmp_path / "address_file"
    browser = tmp_path / "browser.sh"
    browser.write_text(f'#!/bin/sh\necho "$1" >> {addresses}\n', encoding="utf-8")
    browser.chmod(0o755)
    monkeypatch.setenv("BROWSER", f"{browser} %s")
    monkeypatch.setenv("DISPLAY", ":99")
    monkeypatch.delenv("SSH_CONNECTION", raising=False)
    monkeypatch.delenv("ZBOT_NO_BROWSER")
    return addresses


def opened_addresses(addresses: Path) -> list[str]:
    return addresses.read_text(encoding="utf-8").split() if addresses.exists() else []


def test_turtlesim_opens_the_page_of_the_turtle(start: Start, address_file: Path) -> None:
    pytest.importorskip("nicegui", reason='the page needs NiceGUI: pip install "zbot[web]"')
    program = start(*RUN)
    program.wait_for("Spawning turtle [turtle1]")
    assert wait_until(lambda: bool(opened_addresses(address_file)), 30)
    (address,) = opened_addresses(address_file)
    assert address.endswith("/turtle?node=/turtlesim")
    with urllib.request.urlopen(address) as page:
        assert page.status == 200
    other = start(*RUN, "--ros-args", "-r", "__ns:=/second")
    other.wait_for("Spawning turtle [turtle1]")
    assert wait_until(lambda: len(opened_addresses(address_file)) == 2, 30)
    root = address.partition("/turtle")[0]
    assert opened_addresses(address_file)[1] == f"{root}/turtle?node=/second/turtlesim"
    assert program.stop(timeout=20) == -2
    assert wait_until(lambda: not is_served(root))


def test_two_turtlesims_share_a_page(start: Start, address_file: Path) -> None:
    pytest.importorskip("nicegui", reason='the page needs NiceGUI: pip install "zbot[web]"')
    launched = start("zbot", "launch", "turtlesim", "multisim.launch.py")
    assert wait_until(lambda: len(opened_addresses(address_file)) == 2, 40)
    roots = {address.partition("/turtle?")[0] for address in opened_addresses(address_file)}
    assert len(roots) == 1
    assert launched.stop(timeout=20) == 0


def test_the_page_ends_with_a_killed_turtlesim(start: Start, address_file: Path) -> None:
    pytest.importorskip("nicegui", reason='the page needs NiceGUI: pip install "zbot[web]"')
    program = start(*RUN)
    assert wait_until(lambda: bool(opened_addresses(address_file)), 30)
    program.process.kill()
    assert wait_until(lambda: not is_served(opened_addresses(address_file)[0]), 20)


def is_served(address: str) -> bool:
    try:
        with urllib.request.urlopen(address):
            return True
    except OSError:
        return False


@pytest.mark.parametrize(
    ("words", "variables"), [(("--no-browser",), {}), ((), {"ZBOT_NO_BROWSER": "1"})]
)
def test_turtlesim_opens_no_page_when_it_is_switched_off(
    start: Start, address_file: Path, words: tuple[str, ...], variables: dict[str, str]
) -> None:
    program = start(*RUN, *words, env=variables)
    program.wait_for("Spawning turtle [turtle1]")
    assert start("zbot", "topic", "echo", "--once", "/turtle1/pose").wait() == 0
    assert opened_addresses(address_file) == []
    assert program.stop() == -2


def test_turtlesim_runs_without_the_extra_and_prints_the_install_command(
    start: Start, address_file: Path, tmp_path: Path
) -> None:
    hidden = "import sys; sys.modules['nicegui'] = None\n"
    (tmp_path / "sitecustomize.py").write_text(hidden, encoding="utf-8")
    path = os.pathsep.join((str(tmp_path), os.environ["PYTHONPATH"]))
    program = start(*RUN, env={"PYTHONPATH": path})
    program.wait_for(HINT)
    assert start("zbot", "topic", "echo", "--once", "/turtle1/pose").wait() == 0
    assert opened_addresses(address_file) == []
    assert program.stop() == -2


def test_without_a_desktop_one_line_says_how_to_see_the_turtles(
    start: Start, address_file: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("nicegui", reason='the page needs NiceGUI: pip install "zbot[web]"')
    monkeypatch.setenv("SSH_CONNECTION", "somewhere")
    program = start(*RUN)
    program.wait_for("`zbot web` prints the address of the turtles")
    program.stop()
    assert opened_addresses(address_file) == []
