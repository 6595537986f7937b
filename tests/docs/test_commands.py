"""Every command that the documentation names exists, with its verb and its options.

This covers the guides too, whose commands need robots, several machines or a browser.
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from zbot_cli.main import NOUNS
from zbot_cli.nouns import load, verbs

ROOT = Path(__file__).parents[2]
PAGES = sorted(
    page
    for page in (*ROOT.glob("docs/**/*.md"), ROOT / "README.md", ROOT / "examples" / "README.md")
    if "reference/api" not in page.as_posix()
)
#: A command in a block, behind a prompt, or in a sentence.
_LINE = re.compile(r"(?:^ {4} *|^ *\w*\$ |`)zbot ([a-z][^`\n]*)", re.MULTILINE)
_GENERAL = {"--help", "--rmw"}  #: options of all commands
_MISTAKES = {"topc list"}  #: a page shows what zbot answers
#: These pass their options on to a program, or read them themselves.
_PASS_ON = {"run", "launch", "test", "complete"}


@cache
def command(noun: str) -> Any:
    return load(noun)


def mistake(line: str) -> str | None:
    """Return what is wrong with the words after `zbot`, if something is."""
    own = re.split(r" -- | \| |  ", line)[0]  # without a program's own words and without remarks
    noun, *words = [word.rstrip(".,:;)") for word in own.split()]
    if noun not in NOUNS:
        return f"no command {noun!r}"
    if noun in _PASS_ON:
        return None
    chosen = command(noun)
    found = verbs(chosen)
    if found:
        verb = words[0] if words else ""
        if not re.fullmatch("[a-z_]+", verb):
            return None  # a placeholder, e.g. VERB
        if verb not in found:
            return f"no verb {verb!r}"
        chosen = found[verb]
    known = {option for param in chosen.params for option in (*param.opts, *param.secondary_opts)}
    named = {word.partition("=")[0] for word in words if re.match("--[a-z]", word)}
    unknown = sorted(named - known - _GENERAL)
    return f"no option {', '.join(unknown)}" if unknown else None


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_the_commands_of_a_page_exist(page: Path) -> None:
    lines = _LINE.findall(page.read_text(encoding="utf-8"))
    wrong = {line: mistake(line) for line in lines if line not in _MISTAKES}
    assert not {line: text for line, text in wrong.items() if text}
