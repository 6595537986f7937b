"""Tests of the names of rqt, which open panels of the page."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

import pytest

from tests.conftest import wait_until
from zbot.package.bundled_nodes import BUNDLED_NODES, BUNDLED_PROGRAMS
from zbot.package.zbot_command import find_on_path
from zbot_nodes.page.rqt import PANELS, panel_path

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import Start


@pytest.mark.parametrize(
    ("words", "path"),
    [
        (["rqt_graph"], "/graph"),
        (
            ["rqt_plot", "/turtle1/pose/x", "/turtle1/pose/y"],
            "/plot?curve=/turtle1/pose/x,/turtle1/pose/y",
        ),
        (["rqt_image_view", "/camera/image"], "/pictures?topics=/camera/image"),
        (["rqt", "--force-discover", "-s", "rqt_console"], "/console"),
        (["rqt_gui", "--standalone", "rqt_reconfigure.reconfigure"], "/parameters"),
        (["rqt", "-s", "rqt_robot_monitor"], "/diagnostics"),
        (["rqt", "-s", "rqt_unknown"], "/graph"),
        (["rqt", "-s"], "/graph"),
        (["rqt_reconfigure", "/a node"], "/parameters?node=/a%20node"),
    ],
)
def test_a_command_line_names_a_panel(words: list[str], path: str) -> None:
    assert panel_path(words[0], words[1:]) == path


def test_every_name_has_a_panel_of_the_page() -> None:
    pytest.importorskip("nicegui", reason='the page needs NiceGUI: pip install "zbot[web]"')
    from zbot.web.panels import PANELS as OF_THE_PAGE  # noqa: PLC0415 - imports NiceGUI

    assert {path for path, _ in PANELS.values()} <= {panel.path for panel in OF_THE_PAGE}
    assert {name for name in BUNDLED_PROGRAMS if name.startswith("rqt")} == set(PANELS)
    assert all(package in BUNDLED_NODES for package in BUNDLED_PROGRAMS.values())


def test_without_a_desktop_a_sentence_says_how_to_see_the_page(
    start: Start, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("ZBOT_NO_BROWSER")
    monkeypatch.setenv("SSH_CONNECTION", "a 1 b 2")
    program = start("zbot", "run", "rqt_graph", "rqt_graph")
    program.wait_for("the page")
    assert program.wait() == 0


@pytest.mark.skipif(sys.platform == "win32", reason="a browser is chosen otherwise")
def test_a_name_opens_its_panel(
    start: Start, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("nicegui", reason='the page needs NiceGUI: pip install "zbot[web]"')
    opened = tmp_path / "opened"
    browser = tmp_path / "browser.sh"
    browser.write_text(f'#!/bin/sh\necho "$1" >> {opened}\n')
    browser.chmod(0o755)
    monkeypatch.setenv("BROWSER", f"{browser} %s")
    monkeypatch.setenv("DISPLAY", ":99")
    monkeypatch.delenv("SSH_CONNECTION", raising=False)
    monkeypatch.delenv("ZBOT_NO_BROWSER")
    program = start("zbot", "run", "rqt_console", "rqt_console")
    assert wait_until(opened.exists, 30)
    assert wait_until(lambda: opened.read_text().strip().endswith("/console"), 10)
    assert program.stop(timeout=20) == -2


def test_launches_find_the_programs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    for name in ("rqt", "rqt_plot"):
        found = find_on_path(name, {"PATH": str(tmp_path)})
        assert found is not None
        assert found.startswith(str(tmp_path))
    assert find_on_path("rqt_multiplot", {"PATH": str(tmp_path)}) is None


def test_a_launch_file_starts_a_program_of_rqt(
    start: Start, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ZBOT_LOG_DIR", str(tmp_path / "log"))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    (tmp_path / "a.launch.xml").write_text(
        '<launch><executable cmd="rqt_graph"/><executable cmd="xacro --help"/>'
        '<executable cmd="command -v xacro" shell="true" output="screen"/></launch>'
    )
    monkeypatch.setenv("PATH", "/usr/bin:/bin")
    program = start("zbot", "launch", "a.launch.xml")
    program.wait()
    assert "[rqt_graph-1]: process has finished cleanly" in program.output
    assert "/xacro" in program.output
