"""Code blocks of a Markdown page, with the files and the commands that they contain.

The conventions are described in CONTRIBUTING.md.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

from markdown_it import MarkdownIt

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

_FILE = re.compile(r"as `([^`]+)`:$")
_CHANGE = re.compile(r"replace `([^`]+)` in `([^`]+)` by:$", re.IGNORECASE)
_NOTE = re.compile(r"<!-- test: (.*?) -->", re.DOTALL)
#: Commands that run until Ctrl-C, unless the page shows all of their output.
_ENDLESS = re.compile(
    r"(zbot|ros2) (run|launch|sim|serial|web|plot|hub|bag (record|play))\b"
    r"|(zbot|ros2) topic (echo|hz|bw|delay|pub)\b"
    r"(?!.* --once)|python|rqt|jupyter"
)
_PROMPT = re.compile(r"(\w*)\$ (.*)")


@dataclass(frozen=True)
class Block:
    """Code block: its language, its text, and the paragraph before it."""

    language: str
    text: str
    before: str
    line: int

    @property
    def file(self) -> str:
        """Path of the file that has this text, or an empty string."""
        found = _FILE.search(self.before)
        return found[1] if found else ""

    @property
    def change(self) -> tuple[str, str] | None:
        """The text that this block replaces, and the file that contains it."""
        found = _CHANGE.search(self.before)
        return (found[1], found[2]) if found else None


@dataclass(frozen=True)
class Note:
    """Comment of a page that only the test reads, e.g. that a program is stopped here."""

    text: str
    line: int


@dataclass(frozen=True)
class Command:
    """Command line in a block of the language `console`, and the output below it."""

    machine: str
    line: str
    output: tuple[str, ...]

    @property
    def is_interrupted(self) -> bool:
        """Whether the reader ends it with Ctrl-C."""
        return self.output[-1:] == ("^C",)

    @property
    def is_endless(self) -> bool:
        """Whether it runs until Ctrl-C: with `...` it still runs during the next commands."""
        goes_on = self.output[-1:] == ("...",) and _ENDLESS.match(self.line) is not None
        return self.is_interrupted or goes_on


def parts(page: Path) -> list[Block | Note]:
    """Return the code blocks and the comments of a page, in their order."""
    return list(_parts(page.read_text(encoding="utf-8")))


def _parts(text: str) -> Iterator[Block | Note]:
    before = ""
    for token in MarkdownIt("commonmark").parse(text):
        line = token.map[0] + 1 if token.map else 0
        if token.type == "inline":
            before = token.content.replace("\n", " ")
        elif token.type in {"fence", "code_block"}:
            yield Block(token.info.split(" ")[0], token.content, before, line)
            before = ""
        elif token.type == "html_block":
            for note in _NOTE.findall(token.content):
                yield Note(note, line)


def commands(block: Block) -> list[Command]:
    """Return the commands of a block of the language `console`."""
    found: list[tuple[str, list[str], list[str]]] = []
    for line in block.text.splitlines():
        prompt = _PROMPT.fullmatch(line)
        if prompt:
            found.append((prompt[1], [prompt[2]], []))
        elif found and found[-1][1][-1].endswith("\\") and not found[-1][2]:
            found[-1][1].append(line)
        elif found:
            found[-1][2].append(line)
        else:
            raise ValueError(f"line {block.line}: a block begins with a command: {line!r}")
    return [Command(machine, "\n".join(lines), tuple(output)) for machine, lines, output in found]
