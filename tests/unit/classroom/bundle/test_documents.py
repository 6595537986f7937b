"""Documentation of a bundle."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.classroom.bundle import documents

if TYPE_CHECKING:
    from pathlib import Path

    import pytest


def test_without_the_packages_for_the_site_the_markdown_is_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(documents, "_MODULES", ("a_module_that_is_not_here",))
    checkout, said = tmp_path / "zbot", list[str]()
    for name in ("docs/index.md", "docs/conf.py", "docs/generator/api.py", "examples/maze.py"):
        (checkout / name).parent.mkdir(parents=True, exist_ok=True)
        (checkout / name).write_text(name)
    documents.add_documents(checkout, tmp_path / "usb", said.append)
    found = sorted(path.name for path in (tmp_path / "usb").rglob("*") if path.is_file())
    assert found == ["index.md", "maze.py"]
    assert said == [
        'documentation: Markdown files, because the site needs `pip install "zbot[docs]"`'
    ]


def test_without_a_checkout_one_line_says_so(tmp_path: Path) -> None:
    said: list[str] = []
    documents.add_documents(None, tmp_path, said.append)
    assert said == ["documentation: left out, because it is only in a checkout of zbot"]
    assert not list(tmp_path.iterdir())
