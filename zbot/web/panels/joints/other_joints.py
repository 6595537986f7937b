"""Positions of the joints without a slider, e.g. of those that follow another joint."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from nicegui import ui

if TYPE_CHECKING:
    from collections.abc import Callable, Collection

    from zbot.observer.watch import Watch
    from zbot.web.page.panel import Section

_HZ = 5.0
_MOST = 200


class OtherJoints:
    """Lines with the joints of a topic. The constructor adds them to the current element.

    Args:
        section: The section of the page.
        watch: The watch of the topic.
        sliders: Function that returns the joints that have a slider.
    """

    def __init__(
        self, section: Section, watch: Watch, sliders: Callable[[], Collection[str]]
    ) -> None:
        self._watch, self._sliders = watch, sliders
        self._label = ui.label().classes("zb-mono zb-muted zb-other-joints")
        section.live(self._update, _HZ)

    def _update(self) -> None:
        self._label.set_text("\n".join(other_joints(self._watch.latest, self._sliders())))


def other_joints(message: Any, sliders: Collection[str]) -> list[str]:
    """Return a line for each joint in a message that has no slider.

    Args:
        message: A JointState, whose lists may be too short, or None.
        sliders: The joints with a slider.
    """
    if message is None or not sliders:
        return []
    positions = zip(message.name, message.position, strict=False)
    others = [(name, at) for name, at in positions if name not in sliders and math.isfinite(at)]
    return [f"{name} follows: {at:.3f}" for name, at in others[:_MOST]]
