"""Tests of docs/security.md, which names the test of each of its claims."""

from __future__ import annotations

import re
from pathlib import Path

ROOT = Path(__file__).parents[3]
DEFINITION = re.compile(r"^def (test_\w+)", re.MULTILINE)


def test_every_test_that_the_page_names_exists() -> None:
    page = (ROOT / "docs" / "security.md").read_text(encoding="utf-8")
    named = set(re.findall(r"`(test_\w+)`", page))
    sources = (path.read_text(encoding="utf-8") for path in (ROOT / "tests").rglob("test_*.py"))
    written = {name for source in sources for name in DEFINITION.findall(source)}
    assert len(named) > 40
    assert named <= written, named - written


def test_every_attack_test_is_named_on_the_page() -> None:
    page = (ROOT / "docs" / "security.md").read_text(encoding="utf-8")
    modules = (ROOT / "tests" / "classroom" / "attacks").glob("test_*.py")
    attacks = "".join(path.read_text(encoding="utf-8") for path in modules)
    assert not [name for name in DEFINITION.findall(attacks) if name not in page]


def test_every_promise_names_a_test_and_what_it_does_not_include() -> None:
    page = (ROOT / "docs" / "security.md").read_text(encoding="utf-8")
    section = page.partition("\n## Promises\n")[2].partition("\n## ")[0]
    rows = re.findall(r"^\| (.+?) \| (.+?) \| (.+?) \|$", section, re.MULTILINE)
    assert len(rows) > 10
    for promise, tests, left_out in rows[1:]:
        assert promise.endswith(".")
        assert "`test_" in tests, promise
        assert left_out.strip(), promise
