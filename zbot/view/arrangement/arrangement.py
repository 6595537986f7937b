"""Arrangement of a view, without the form of a file."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Mapping

    from zbot.view.camera import Camera
    from zbot.view.displays.display import Value
    from zbot.view.shape import Color


@dataclass(frozen=True)
class DisplayChoice:
    """Display of an arrangement.

    Attributes:
        kind: The name of the display. It is empty for a display that the view does not have.
        label: The name that the user gave to it.
        topic: Its topic as in the file, e.g. `scan`. It is empty for a display without a topic.
        is_on: Whether it is on.
        values: The settings that differ from their first values.
        file: The file with the robot description, in place of the topic.
        groups: The names of the groups that it is in, from the outer one to the inner one.
        raw: All properties in the file. They are written again, also those that do not fit.
    """

    kind: str
    label: str
    topic: str = ""
    is_on: bool = True
    values: Mapping[str, Value] = field(default_factory=dict)
    file: str = ""
    groups: tuple[str, ...] = ()
    raw: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class PointerTopics:
    """Topics of the tools, and the variances of an initial pose."""

    initial_pose: str = "initialpose"
    goal: str = "goal_pose"
    point: str = "clicked_point"
    variance_xy: float = 0.25  #: m², as in rviz
    variance_yaw: float = 0.06853891909122467  #: rad², as in rviz


@dataclass(frozen=True)
class Arrangement:
    """Displays, fixed frame and camera of a view.

    Attributes:
        displays: The displays, in the order of the file.
        fixed_frame: The fixed frame. If it is empty, the view chooses it.
        camera: The camera, or None for the view's own.
        background: The colour behind the scene, or None for the view's own.
        topics: The topics of the tools.
        misfits: What the view does not have, e.g. `GridMap` or `LaserScan: Decay Time`.
        raw: The whole file, for what is written again.
    """

    displays: tuple[DisplayChoice, ...] = ()
    fixed_frame: str = ""
    camera: Camera | None = None
    background: Color | None = None
    topics: PointerTopics = PointerTopics()
    misfits: tuple[str, ...] = ()
    raw: Mapping[str, Any] = field(default_factory=dict)

    @property
    def misfit_sentence(self) -> str:
        """A sentence that names what the view does not have, or an empty text."""
        if not self.misfits:
            return ""
        return f"the file has parts that the view does not have: {', '.join(self.misfits)}"
