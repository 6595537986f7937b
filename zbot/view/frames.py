"""Frames of a scene: the fixed frame, the pose of each frame in it, and what is missing."""

from __future__ import annotations

import time
from dataclasses import dataclass
from itertools import islice
from typing import TYPE_CHECKING, Any

from zbot.tf2.broadcaster import TF_STATIC_TOPIC
from zbot.tf2.buffer import Buffer
from zbot.tf2.diagnosis import Diagnosis
from zbot.tf2.errors import TransformException
from zbot.tf2.rigid import Rigid

from tf2_msgs.msg import TFMessage

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from zbot.tf2.frame import Sample

#: With two trees of the same size, the first of these frames is preferred.
_USUAL = ("map", "odom", "world", "base_footprint", "base_link")
_MOST_FRAMES = 5000  #: a program may give each transform another name
#: rviz waits for the transform of a message. A message that is newer by less than this is usual.
_USUAL_GAP_NS = 500_000_000


@dataclass(frozen=True)
class Tree:
    """Frames at one moment.

    Attributes:
        parents: The parent of each frame that has one.
        poses: The newest pose in the fixed frame, for each frame that is connected to it.
    """

    parents: Mapping[str, str]
    poses: Mapping[str, Rigid]

    @property
    def roots(self) -> list[str]:
        """The frames without a parent, each with a tree of its own."""
        return list(dict.fromkeys(self.all_roots().values()))

    def all_roots(self) -> dict[str, str]:
        """Return the root of the tree of each frame with a parent.

        The root of a frame below a loop is the first frame of the loop on its way. A frame of a
        loop is its own root.
        """
        found: dict[str, str] = {}
        for name in self.parents:
            way: dict[str, None] = {}
            at = name
            while at in self.parents and at not in found and at not in way:
                way[at] = None
                at = self.parents[at]
            names = list(way)
            end = names.index(at) if at in way else len(names)  # the rest is a loop
            found.update(dict.fromkeys(names[:end], found.get(at, at)))
            found.update((frame, frame) for frame in names[end:])
        return found

    @property
    def names(self) -> list[str]:
        """All frames, sorted."""
        return sorted({*self.parents, *self.parents.values()})


class Frames(Buffer):
    """Buffer of transforms with a fixed frame. The scene does not move in this frame.

    Attributes:
        fixed: The fixed frame, or an empty text as long as no frame is known.
        is_chosen: Whether the user has chosen the fixed frame.
        tree: The frames at the last `refresh`.
        diagnosis: What was heard about transforms. It says why one is missing.
        now_ns: Function that returns the time at which transforms were heard.
    """

    def __init__(self) -> None:
        super().__init__()
        self.fixed = ""
        self.is_chosen = False
        self.tree = Tree({}, {})
        self.diagnosis = Diagnosis()
        self.now_ns: Callable[[], int] = time.time_ns

    def add_fixed_link(self, transform: Any) -> None:
        """Add a `TransformStamped` that no node publishes."""
        self.set_transform_static(transform, "zbot view")
        self.diagnosis.add_message(TFMessage(transforms=[transform]), TF_STATIC_TOPIC)

    def choose(self, name: str) -> None:
        """Make a frame the fixed frame. An empty name means the root of the largest tree."""
        self.fixed, self.is_chosen = name, bool(name)

    def note(self, name: str) -> None:
        """Use the frame of a message as long as there are no transforms."""
        if not self.fixed and name:
            self.fixed = name

    def refresh(self) -> Tree:
        """Read the newest transforms, and choose the fixed frame if the user has chosen none."""
        with self._changed:
            frames = islice(self._frames.items(), _MOST_FRAMES)
            samples = {name: frame.newest for name, frame in frames}
        parents = {name: sample.parent for name, sample in samples.items()}
        if parents and not self.is_chosen:
            self.fixed = _largest_root(Tree(parents, {}), self.fixed)
        self.tree = Tree(parents, _poses(samples, self.fixed))
        return self.tree

    def pose(self, frame: str, stamp_ns: int) -> tuple[Rigid | None, bool]:
        """Return the pose of a frame in the fixed frame, and whether it is right.

        Without a pose at the time, the newest pose is returned. Without a transform, the pose is
        None. `why` then has the reason.

        Args:
            frame: The frame. An empty name means the fixed frame.
            stamp_ns: The time, or 0 for the newest pose.
        """
        if frame in {"", self.fixed}:
            return Rigid(), True
        newest = self.tree.poses.get(frame)
        if newest is None or not stamp_ns:
            return newest, newest is not None
        try:
            with self._changed:
                return self._find(self.fixed, frame, stamp_ns)[0], True
        except TransformException:
            with self._changed:
                gap_ns = stamp_ns - self._latest_common_ns(self.fixed, frame)
            return newest, 0 <= gap_ns < _USUAL_GAP_NS

    def exact_pose(self, frame: str, stamp_ns: int) -> Rigid | None:
        """Return the pose of a frame in the fixed frame at a time, or None if it is not known."""
        if frame in {"", self.fixed}:
            return Rigid()
        try:
            with self._changed:
                return self._find(self.fixed, frame, stamp_ns)[0] if stamp_ns else None
        except TransformException:
            return None

    def why(self, frame: str, stamp_ns: int, topic: str) -> str:
        """Return why a pose is missing or not right, and what to do. It is empty if all is well."""
        problem = self.diagnosis.why(
            self.fixed,
            frame,
            stamp_ns,
            what="the newest message",
            message_topic=topic,
            now_ns=self.now_ns(),
        )
        return "" if problem is None else f"{problem.text}\n→ {problem.advice}"


def _largest_root(tree: Tree, present: str) -> str:
    sizes: dict[str, int] = {}
    for root in tree.all_roots().values():
        sizes[root] = sizes.get(root, 0) + 1
    usual = {name: len(_USUAL) - place for place, name in enumerate(_USUAL)}
    return max(sizes, key=lambda root: (sizes[root], root == present, usual.get(root, 0), root))


def _poses(samples: Mapping[str, Sample], fixed: str) -> dict[str, Rigid]:
    """Return the newest pose in the fixed frame, for each frame that is connected to it."""
    in_root: dict[str, tuple[str, Rigid]] = {}
    for name in {*samples, *(sample.parent for sample in samples.values())}:
        _climb(name, samples, in_root)
    root, pose = in_root.get(fixed, (fixed, Rigid()))
    back = pose.inverse()
    return {
        name: Rigid() if name == fixed else back @ there
        for name, (its_root, there) in in_root.items()
        if its_root == root
    }


def _climb(name: str, samples: Mapping[str, Sample], in_root: dict[str, tuple[str, Rigid]]) -> None:
    """Add the root of a frame and the frame's pose in it, also for the frames on the way."""
    way: dict[str, None] = {}
    while name not in in_root and name in samples and name not in way:
        way[name] = None
        name = samples[name].parent
    root, pose = in_root.setdefault(name, (name, Rigid()))
    for frame in reversed(way):
        if frame != name:  # in a loop, the frame `name` is the root
            pose = pose @ samples[frame].pose
            in_root[frame] = root, pose
