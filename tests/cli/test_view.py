from __future__ import annotations

import socket
from typing import TYPE_CHECKING

import pytest

from zbot.errors.installation import pip_install

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from tests.conftest import Program

WITHOUT_EXTRA = """
import importlib.util, sys
find = importlib.util.find_spec
importlib.util.find_spec = lambda name, *rest: None if name == "viser" else find(name, *rest)
from zbot_cli.main import main
sys.argv = ["zbot", "view"]
main()
"""
NOT_IMPORTED = """
import sys
EXTRA = "viser", "trimesh", "numpy", "PIL", "websockets"
import zbot, zbot.compat, zbot_cli.main, zbot_cli.commands.view
import zbot.view.server.server
print("imported:", sorted({*EXTRA} & sys.modules.keys()))
"""


def test_a_missing_extra_is_reported_with_the_remedy(start: Callable[..., Program]) -> None:
    program = start(source=WITHOUT_EXTRA)
    assert program.wait(30) == 1
    assert program.lines == [f"the view needs viser: install it with {pip_install('zbot[view]')}"]


def test_only_the_running_view_imports_the_extra(start: Callable[..., Program]) -> None:
    program = start(source=NOT_IMPORTED)
    program.wait_for("imported: []")


@pytest.mark.parametrize(
    ("name", "text", "reason"),
    [
        ("a.urdf", "<robot", "the robot description is not valid: line 1: "),
        ("a.urdf", "\0", "the robot description is not valid: "),
        ("a.urdf.xacro", "", "is a file for xacro: type 'xacro "),
    ],
)
def test_a_file_that_is_no_robot_is_refused(
    start: Callable[..., Program], tmp_path: Path, name: str, text: str, reason: str
) -> None:
    pytest.importorskip("viser", reason='the view needs viser: pip install "zbot[view]"')
    (tmp_path / name).write_text(text, encoding="utf-8")
    program = start("zbot", "view", str(tmp_path / name), "--no-browser")
    assert program.wait(30) == 1
    assert reason in program.output
    assert "Traceback" not in program.output


def test_taken_port_is_replaced_by_the_next_port(start: Callable[..., Program]) -> None:
    pytest.importorskip("viser", reason='the view needs viser: pip install "zbot[view]"')
    with socket.socket() as holder:
        holder.bind(("127.0.0.1", 0))
        holder.listen()
        port = holder.getsockname()[1]
        program = start("zbot", "view", "--no-browser", "--port", str(port))
        line = program.wait_for("zbot view: ", 30)
        assert port < int(line.rstrip("/").rpartition(":")[2]) <= port + 100
        assert program.stop(timeout=15) == 130
        assert program.lines == [line]
