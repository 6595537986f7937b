"""Display TF: the axes, the names and the tree of all frames."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from zbot.view.colors import same
from zbot.view.displays.display import Display, Setting
from zbot.view.frames import Tree
from zbot.view.shape import Axes, Item, Label, Lines

if TYPE_CHECKING:
    from zbot.view.mesh_file import MeshFiles
    from zbot.view.shape import Shape

_YELLOW = (220, 180, 40)
_MOST_NAMES = 100


class TF(Display):
    """Axes of all frames, with lines from each frame to its parent.

    The setting `hidden` has the names of frames that are not shown.
    """

    name = "TF"
    types = ("tf2_msgs/msg/TFMessage",)
    has_topic = False
    settings = (
        Setting("length", 0.3, low=0.02, high=2.0, step=0.02),
        Setting("axes", True),
        Setting("names", True),
        Setting("lines", True),
        Setting("hidden", ""),
    )

    def __init__(self, topic: str, files: MeshFiles | None = None) -> None:
        super().__init__(topic, files)
        self._shown: Any = None

    def take(self, message: Any) -> None:
        """Do nothing: the view has a buffer for all transforms."""

    def follow(self, tree: Tree) -> None:
        """Show the frames at one moment."""
        shown = (tree.poses, dict(self.values))
        if shown == self._shown:
            return
        self._shown = shown
        hidden = self.words("hidden")
        poses = {name: pose for name, pose in tree.poses.items() if name not in hidden}
        items = {"": Item("", 0, tuple(self.frame_shapes(Tree(tree.parents, poses))))}
        if self.values["names"]:
            for name in list(poses)[:_MOST_NAMES]:
                known = self.items.get(f"name {name}")
                items[f"name {name}"] = known or Item(name, 0, (Label(name),))
        self.notice = ""
        if self.values["names"] and len(poses) > _MOST_NAMES:
            self.notice = f"only the first {_MOST_NAMES} names are shown"
        self.items = items

    def frame_shapes(self, tree: Tree) -> list[Shape]:
        """Return the axes and the lines of all frames that are connected to the fixed frame."""
        if not tree.poses:
            return []
        shapes: list[Shape] = []
        if self.values["axes"]:
            shapes.append(Axes(tuple(tree.poses.values()), self.number("length")))
        links = [
            (pose.translation, tree.poses[tree.parents[name]].translation)
            for name, pose in tree.poses.items()
            if tree.parents.get(name) in tree.poses
        ]
        if self.values["lines"] and links:
            ends = np.array(links, np.float32)
            shapes.append(Lines(ends, same(_YELLOW, len(ends), 2), 1.5))
        return shapes
