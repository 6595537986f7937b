"""Panel of frames: the trees with their rates and ages, and what is wrong with them."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

from nicegui import ui

from zbot.tf2.diagnosis.problem import duration_text
from zbot.web.page.list_panel import ListPanel
from zbot.web.page.panel import Page, Panel
from zbot.web.page.table import Cell, Column
from zbot.web.panels.frames.frame_details import FrameDetails
from zbot.web.panels.frames.problem_list import ProblemList

if TYPE_CHECKING:
    from zbot.graph.snapshot import Snapshot
    from zbot.tf2.diagnosis import Branch, Link

_HZ = 2.0
_COLUMNS = (
    Column("Frame", "zb-mono zb-cut"),
    Column("Rate", "zb-number", "88px"),
    Column("Age", "zb-number", "108px"),
    Column("Published by", "zb-mono zb-cut zb-spare zb-wide"),
)


class _Frames:
    def __init__(self, page: Page) -> None:
        self.watch = page.watch_transforms()
        self.number = 0  # how many times the frames were read
        self.names: dict[str, str] = {}  # the frame of each row
        with ui.element("div").classes("zb-fill"):
            self.problems = ProblemList()
            with ui.element("div").classes("zb-grow zb-below"):
                ListPanel(
                    page,
                    columns=_COLUMNS,
                    rows=self.rows,
                    details=lambda section, key: FrameDetails(
                        section, self.watch, self.names.get(key, key)
                    ),
                    key="frame",
                    command="zbot doctor --tf",
                    empty="No frame yet: start a node, e.g. zbot run robot_base",
                    hidden="Other topics",
                    version=lambda: self.number,
                )
        page.live(self.look, _HZ)

    def look(self) -> None:
        """Show the problems, and let the table show the frames."""
        diagnosis = self.watch.diagnosis
        if diagnosis is not None:
            self.number += 1
            self.problems.show(diagnosis.problems() if self.watch.has_listened else ())

    def rows(self, _graph: Snapshot, hidden: bool) -> dict[str, list[str | Cell]]:
        diagnosis = self.watch.diagnosis
        if diagnosis is None:
            return {}
        found: dict[str, list[str | Cell]] = {}
        now_ns = time.time_ns()
        for topic in diagnosis.topics if hidden else diagnosis.topics[:1]:
            for branch in diagnosis.branches(topic):
                key = branch.frame
                if key in found:
                    parent = branch.link.parent if branch.link else ""
                    key = f"{key} in {parent} on {topic}"
                self.names[key] = branch.frame
                found[key] = _row(branch, now_ns)
        return found


def _row(branch: Branch, now_ns: int) -> list[str | Cell]:
    name = branch.frame
    if branch.missing_parent:
        lack = f"{branch.missing_parent} -> {name} is missing"
        frame = Cell(name, "zb-bad", branch.depth, hint=lack)
        return [frame, Cell("missing", "zb-bad"), "", Cell(lack, "zb-bad")]
    hint = "" if branch.link is None else f"{branch.link.name} on {branch.link.topic}"
    return [Cell(name, "", branch.depth, hint=hint or name), *_facts(branch.link, now_ns)]


def _facts(link: Link | None, now_ns: int) -> list[str | Cell]:
    if link is None:
        return ["", "", ""]
    nodes = ", ".join(link.nodes)
    node = Cell(nodes, hint=nodes)
    if link.is_static:
        return [Cell("static", "zb-muted"), "", node]
    if link.is_stale(now_ns):
        silence = f"{duration_text(link.silence_ns(now_ns))} ago"
        return [Cell("stopped", "zb-warn"), Cell(silence, "zb-warn"), node]
    return [link.rate_text, link.age_text(now_ns), node]


def _build(page: Page) -> None:
    _Frames(page)


PANEL = Panel("/frames", "Frames", "account_tree", _build)
