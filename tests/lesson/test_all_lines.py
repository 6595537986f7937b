"""Lines of two lessons about ROS 2, typed unchanged after `zbot setup-shell`, and with `zbot`.

The lines are in `lines/`. The folder has no other text of the lessons.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from tests.docs.story import Story

if TYPE_CHECKING:
    from tests.docs.machines import Machines

LINES = sorted((Path(__file__).parent / "lines").glob("*.md"))
#: What somebody types who has not set up the names of ROS 2.
IN_ZBOT = (
    (r"^(\$ |<!-- test: \w+ (?:up in )?)ros2\b", r"\1zbot"),
    (r"^\$ colcon\b", "$ zbot"),
    (r"^\$ ros(node|topic)\b", r"$ zbot \1"),
    (r"^\$ rqt_graph\b", "$ zbot web graph"),
    (r"^\$ eval .*", "$ true"),
)

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="the lessons use bash")


# One lesson is enough for the other words: the pages in `docs/` use them.
@pytest.mark.parametrize(
    ("page", "typed"),
    [*((page, "ros2") for page in LINES), (LINES[0], "zbot")],
    ids=lambda path: getattr(path, "stem", path),
)
def test_every_line_of_a_lesson_works(
    page: Path, typed: str, tmp_path: Path, machines: Machines
) -> None:
    text = page.read_text(encoding="utf-8")
    if typed == "zbot":
        for pattern, replacement in IN_ZBOT:
            text = re.sub(pattern, replacement, text, flags=re.MULTILINE)
        assert "$ ros2" not in text
    copy = tmp_path / page.name
    copy.write_text(text, encoding="utf-8")
    home = tmp_path / "home"
    home.mkdir()
    story = Story(copy, home, machines.environment, machines.translate)
    story.tell()
    assert story.seen, "no command was run"
    assert not [line for line, output in story.seen if "command not found" in output]
