"""Display Path: the line through the poses of a path."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.view.colors import same
from zbot.view.displays.display import Display, Setting
from zbot.view.displays.pose import pose_shapes
from zbot.view.points import positions_of, strip, thinned
from zbot.view.pose import pose_of
from zbot.view.shape import Lines

if TYPE_CHECKING:
    from zbot.view.shape import Shape

_GREEN = (25, 190, 60)
_MAGENTA = (255, 85, 255)
_MOST_POSES = 20_000
_MOST_ARROWS = 2000


class Path(Display):
    """Line through the poses of a path, and the poses on it."""

    name = "Path"
    types = ("nav_msgs/msg/Path",)
    settings = (
        Setting("width", 3.0, low=1.0, high=10.0, step=0.5),
        Setting("color", _GREEN),
        Setting("poses", "none", ("none", "arrow", "axes")),
        Setting("length", 0.3, low=0.02, high=3.0, step=0.02),
        Setting("color of poses", _MAGENTA),
    )

    def shapes(self, message: Any) -> list[Shape]:
        """Return the line of a path."""
        poses = message.poses[thinned(len(message.poses), _MOST_POSES)]
        positions = positions_of((pose.pose.position for pose in poses), "the path")
        if len(positions) < 2:
            self.notice = f"the path has {len(positions)} poses: a line needs two"
            return []
        ends = strip(positions)
        line = Lines(ends, same(self.color(), len(ends), 2), self.number("width"))
        return [line, *self._arrows(message.poses)]

    def _arrows(self, poses: Any) -> list[Shape]:
        way = str(self.values["poses"])
        if way == "none":
            return []
        some = [pose_of(stamped.pose) for stamped in poses[thinned(len(poses), _MOST_ARROWS)]]
        return pose_shapes(some, way, self.number("length"), self.color("color of poses"))
