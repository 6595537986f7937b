"""Report of the benchmark: Markdown that is printed line by line and kept."""

from __future__ import annotations


class Report:
    """Lines of the results file, which are also printed."""

    def __init__(self) -> None:
        self.lines: list[str] = []

    def say(self, line: str = "") -> None:
        print(line, flush=True)
        self.lines.append(line)

    def head(self, title: str, *columns: str) -> None:
        """Begin a table."""
        self.say(f"\n## {title}\n")
        self.row(*columns)
        self.say("|" + "---|" * len(columns))

    def row(self, *cells: object) -> None:
        self.say("| " + " | ".join(map(str, cells)) + " |")
