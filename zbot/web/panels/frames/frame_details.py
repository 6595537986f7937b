"""Details of one frame: its transform, and whether it is known in another frame."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

from nicegui import ui

from zbot.tf2.diagnosis.problem import duration_text
from zbot.web.page.command_line import command_line
from zbot.web.panels.frames.problem_list import ProblemLine

if TYPE_CHECKING:
    from zbot.observer.transforms import TransformWatch
    from zbot.tf2.diagnosis import Diagnosis, Link
    from zbot.web.page.panel import Section

_HZ = 2.0


class FrameDetails:
    """Details of a frame.

    Args:
        section: The section that shows the details.
        watch: The transforms.
        frame: The frame.
    """

    def __init__(self, section: Section, watch: TransformWatch, frame: str) -> None:
        self.section, self.watch, self.frame = section, watch, frame
        self.command = ""
        self.top: str | None = None  # the other frame that is shown as long as the user chose none
        self.facts = ui.element("div").classes("zb-facts")
        self.labels: dict[str, ui.label] = {}
        ui.label("In another frame").classes("zb-heading")
        self.target = ui.select([]).props('dense outlined options-dense aria-label="Frame"')
        self.line = ProblemLine()
        section.live(self.update, _HZ)

    def update(self) -> None:
        """Show the frame as it is now."""
        diagnosis = self.watch.diagnosis
        if diagnosis is None:
            return
        self.offer_targets(diagnosis)
        links = [
            link
            for topic in diagnosis.topics
            for link in diagnosis.links(topic)
            if link.child == self.frame
        ]
        self.show_facts(_facts(links))
        self.explain(diagnosis)

    def offer_targets(self, diagnosis: Diagnosis) -> None:
        """Offer all other frames. Until the user chooses, show the top of the largest tree."""
        forest = diagnosis.forest()
        names = [name for name in forest.frames if name != self.frame]
        if names != self.target.options:
            chosen = self.target.value
            is_kept = chosen in names and chosen != self.top
            self.top = next((root for root in forest.separate_roots if root in names), None)
            self.target.set_options(names, value=chosen if is_kept else self.top)

    def show_facts(self, facts: dict[str, str]) -> None:
        """Show facts by name."""
        if list(facts) != list(self.labels):
            self.facts.clear()
            self.labels = {}
            with self.facts:
                for name in facts:
                    ui.label(name).classes("zb-muted")
                    self.labels[name] = ui.label().classes("zb-mono zb-wrap")
        for name, text in facts.items():
            self.labels[name].set_text(text)

    def explain(self, diagnosis: Diagnosis) -> None:
        """Say whether the transform to the chosen frame is known, and if not, why."""
        target = self.target.value
        if not target:
            return
        found = diagnosis.why(target, self.frame)
        self.line.show(found, f"The transform from {self.frame} to {target} is known.")
        words = ["run", "tf2_ros", "tf2_echo"] if found is None else ["doctor", "--tf"]
        command = command_line(*words, target, self.frame)
        if command != self.command:
            self.command = command
            self.section.page.show_command(command)


def _facts(links: list[Link]) -> dict[str, str]:
    """Return the facts about the transforms of a frame, which are several after a mistake."""
    if not links:
        return {"Parent": "none"}
    now_ns = time.time_ns()
    moving = [link for link in links if not link.is_static]
    facts = {
        "Parent": "\n".join(dict.fromkeys(link.parent for link in links)),
        "Topic": "\n".join(dict.fromkeys(link.topic for link in links)),
        "Nodes": "\n".join(dict.fromkeys(name for link in links for name in link.nodes)),
    }
    for link in moving[:1]:
        facts["Rate"] = link.rate_text
        facts["Longest gap"] = duration_text(link.longest_gap_ns)
        facts["Newest"] = link.age_text(now_ns)
    return facts
