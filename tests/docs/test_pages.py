"""Each page of the documentation is followed from top to bottom, in bash."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from tests.docs.story import Story

if TYPE_CHECKING:
    from tests.docs.machines import Machines

DOCS = Path(__file__).parents[2] / "docs"
#: Pages that `python -m docs.generator` writes from the code.
GENERATED = re.compile("reference/(commands.md|api/.*)")
#: What is followed. The guides beside these folders have tests of their own: they need robots,
#: several machines, a browser or an attacker. The pages about the design give no tasks.
FOLLOWED = re.compile(r"(start|learn|how-to|reference)/.*|(bags|index|launch|trouble)\.md")
PAGES = {path.relative_to(DOCS).as_posix() for path in DOCS.glob("**/*.md")}

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="the pages are followed in bash")


@pytest.mark.parametrize(
    "name",
    [page for page in sorted(PAGES) if FOLLOWED.fullmatch(page) and not GENERATED.fullmatch(page)],
)
def test_a_page_can_be_followed(name: str, tmp_path: Path, machines: Machines) -> None:
    home = tmp_path / "home"
    home.mkdir()
    Story(DOCS / name, home, machines.environment, machines.translate).tell()
