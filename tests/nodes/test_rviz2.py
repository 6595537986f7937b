"""Tests of the name of rviz2, which opens the 3D view."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from zbot_nodes.page.rviz2 import Options, read_options

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import Start


@pytest.mark.parametrize(
    ("words", "options"),
    [
        ([], Options()),
        (["-d", "a.rviz"], Options("a.rviz")),
        (["--display-config=a.rviz", "-f", "odom"], Options("a.rviz", "odom")),
        (["a.rviz"], Options("a.rviz")),
        (["-d", ""], Options()),
        (["-s", "none", "-d"], Options()),
        (["--stereo", "-t", "My robot", "a.rviz"], Options("a.rviz")),
    ],
)
def test_the_options_of_rviz2_are_read(words: list[str], options: Options) -> None:
    assert read_options(words) == options


def test_a_missing_file_is_named_and_the_view_opens(start: Start, tmp_path: Path) -> None:
    pytest.importorskip("viser", reason='the view needs viser: pip install "zbot[view]"')
    program = start("zbot", "run", "rviz2", "rviz2", "-d", str(tmp_path / "no.rviz"))
    program.wait_for("[rviz2]: zbot view: http://", 30)
    assert "no.rviz: No such file or directory; the usual displays are shown" in program.output
    assert program.stop(timeout=20) == -2
