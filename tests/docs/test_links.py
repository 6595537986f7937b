"""Every page is near: a reader finds it from the first page, also on a code host."""

from __future__ import annotations

import re
from pathlib import Path

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
_LINK = re.compile(r"\]\(([^)#:\s]+\.md)(?:#[^)]*)?\)")


def linked(page: Path) -> set[Path]:
    """Return the pages to which a page has a link, without the navigation of the site."""
    text = page.read_text(encoding="utf-8")
    return {(page.parent / target).resolve() for target in _LINK.findall(text)}


def test_every_page_is_two_clicks_from_the_first_page() -> None:
    first = DOCS / "index.md"
    one_click = linked(first)
    two_clicks = set().union(*map(linked, one_click)) | one_click | {first}
    folders = ("start", "learn", "how-to", "reference", "design")
    pages = {page for folder in folders for page in (DOCS / folder).glob("*.md")}
    assert not pages - two_clicks


def test_no_link_leads_nowhere() -> None:
    pages = [*DOCS.glob("**/*.md"), ROOT / "README.md", ROOT / "examples" / "README.md"]
    missing = {
        (page.name, target) for page in pages for target in linked(page) if not target.is_file()
    }
    assert not missing
