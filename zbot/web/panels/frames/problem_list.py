"""List of the problems of all frames, each with what to type."""

from __future__ import annotations

from typing import TYPE_CHECKING

from nicegui import ui

from zbot.errors import counted

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.tf2.diagnosis import Problem

_MOST_SHOWN = 50


class ProblemList:
    """Card with the problems. It is hidden as long as there are none."""

    def __init__(self) -> None:
        self._card = ui.element("div").classes("zb-card zb-col zb-problems")
        self._card.props('tabindex=0 role=region aria-label="Problems"')
        self._card.set_visibility(False)
        self._keys: list[object] = []
        self._lines: list[ProblemLine] = []

    def show(self, problems: Sequence[Problem]) -> None:
        """Show the first problems, and how many more there are.

        If only ages have changed, only these texts are sent to the browser.
        """
        more = max(0, len(problems) - _MOST_SHOWN)
        problems = problems[:_MOST_SHOWN]
        keys: list[object] = [
            (problem.cause, problem.frames, problem.is_warning) for problem in problems
        ]
        keys.append(more)
        if keys != self._keys:
            self._keys = keys
            self._card.clear()
            self._card.set_visibility(bool(problems))
            with self._card:
                self._lines = [ProblemLine() for _ in problems]
                if more:
                    ui.label(f"and {counted(more, 'more problem')}").classes("zb-muted")
        for line, problem in zip(self._lines, problems, strict=True):
            line.show(problem)


class ProblemLine:
    """Sentence about a problem, and what to type below it."""

    def __init__(self) -> None:
        with ui.element("div"):
            self._text = ui.label().classes("zb-wrap")
            self._advice = ui.label().classes("zb-muted zb-wrap")

    def show(self, problem: Problem | None, good: str = "") -> None:
        """Show a problem. If there is none, show the text `good`."""
        colour = "zb-good" if problem is None else "zb-warn" if problem.is_warning else "zb-bad"
        self._text.set_text(good if problem is None else problem.text)
        self._text.classes(replace=f"zb-wrap {colour}")
        self._advice.set_text("" if problem is None else problem.advice)
