"""Lines of two lessons about ROS 2, typed unchanged after `zbot setup-shell`.

The lines are in `lines/`. The folder has no other text of the lessons. The pages in `docs/` and
`test_commands.py` type such lines with `zbot`.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from tests.docs.story import Story

if TYPE_CHECKING:
    from tests.docs.machines import Machines

LINES = sorted((Path(__file__).parent / "lines").glob("*.md"))

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="the lessons use bash")


@pytest.mark.parametrize("page", LINES, ids=lambda path: path.stem)
def test_every_line_of_a_lesson_works(page: Path, tmp_path: Path, machines: Machines) -> None:
    home = tmp_path / "home"
    home.mkdir()
    story = Story(page, home, machines.environment, machines.translate)
    story.tell()
    assert story.seen, "no command was run"
    assert not [line for line, output in story.seen if "command not found" in output]
