"""The page about the installation has the commands of the README, which the checks run."""

from __future__ import annotations

from pathlib import Path

from tests.docs.page import Block, parts

ROOT = Path(__file__).parents[2]


def test_the_commands_are_those_of_the_readme() -> None:
    blocks = [part for part in parts(ROOT / "docs/start/install.md") if isinstance(part, Block)]
    lines = [line for block in blocks if block.language == "sh" for line in block.text.splitlines()]
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    assert lines
    assert not [line for line in lines if f"    {line}\n" not in readme]
