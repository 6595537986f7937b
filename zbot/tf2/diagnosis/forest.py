"""Forest of frames: the trees that the links of one pair of topics form."""

from __future__ import annotations

from collections import Counter
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

from zbot.errors.suggestion import nearest

if TYPE_CHECKING:
    from collections.abc import Collection, Iterable, Iterator, Sequence

    from zbot.tf2.diagnosis.link import Link

#: Frames of REP 105, and the one that is often above them, from the top of the tree down.
_USUAL_ORDER = ("world", "earth", "map", "odom", "base_footprint", "base_link")


class Branch(NamedTuple):
    """Line of a drawing of the trees.

    Attributes:
        depth: The number of frames above.
        frame: The frame.
        link: The transform in the frame above, or None for the top of a tree.
        missing_parent: The frame from which nobody publishes a transform, or an empty text.
    """

    depth: int
    frame: str
    link: Link | None
    missing_parent: str = ""


class Forest:
    """Trees of frames at one moment.

    Args:
        links: The links that were heard.
        ended: Those of them whose publishers have ended.
    """

    def __init__(self, links: Sequence[Link], ended: Collection[Link] = ()) -> None:
        self.links = _without_replaced(links, ended)

    @cached_property
    def links_of(self) -> dict[str, list[Link]]:
        """The links of each child, the latest first."""
        found: dict[str, list[Link]] = {}
        for link in sorted(self.links, key=lambda link: link.last_received_ns, reverse=True):
            found.setdefault(link.child, []).append(link)
        return found

    @cached_property
    def frames(self) -> list[str]:
        """All frames, sorted."""
        return sorted({name for link in self.links for name in (link.parent, link.child)})

    @cached_property
    def roots(self) -> list[str]:
        """Frames without a parent, sorted. A loop has no root."""
        return [name for name in self.frames if name not in self.links_of]

    @cached_property
    def separate_roots(self) -> list[str]:
        """The roots of trees that nothing connects, that of the largest tree first.

        A tree is connected too if one of its frames has another parent in the first tree.
        """
        sizes = Counter(map(self.root, self.frames))
        first, *others = sorted(self.roots, key=lambda root: -sizes[root]) or [""]
        joined: set[str] = set()
        for child in self.links_of:
            roots = {self.root(parent) for parent in self.parents(child)}
            joined |= roots if first in roots else set()
        return [first, *(other for other in others if other not in joined)]

    @property
    def tops(self) -> list[str]:
        """The first frame of each tree: its root, or the first frame of a loop."""
        return [*self.roots, *(loop[0] for loop in self.loops())]

    def parents(self, frame: str) -> list[str]:
        """Return the parents of a frame, the latest first. A valid tree has at most one."""
        return list(dict.fromkeys(link.parent for link in self.links_of.get(frame, ())))

    @cached_property
    def _links_below(self) -> dict[str, list[Link]]:
        found: dict[str, list[Link]] = {}
        for link in sorted(self.links, key=lambda link: link.child):
            found.setdefault(link.parent, []).append(link)
        return found

    def branches(self, missing: Iterable[tuple[str, str]] = ()) -> Iterator[Branch]:
        """Yield the lines of a drawing: each frame is below its parent.

        A frame with several parents is below each of them, but its children come only once.

        Args:
            missing: Parents and children of links that nobody publishes. The tree of such a child
                is drawn below the parent.
        """
        lacking = {child: parent for parent, child in missing}
        frames = set(self.frames)
        tops = [top for top in self.tops if lacking.get(top) not in frames]
        waiting = [Branch(0, top, None, lacking.get(top, "")) for top in reversed(tops)]
        drawn: set[str] = set()
        # This is not recursive, because a chain of frames may be too long for recursion.
        while waiting:
            branch = waiting.pop()
            yield branch
            depth, frame = branch.depth + 1, branch.frame
            if frame in drawn:
                continue
            drawn.add(frame)
            apart = [child for child, parent in lacking.items() if parent == frame]
            waiting += [Branch(depth, child, None, frame) for child in reversed(apart)]
            links = reversed(self._links_below.get(frame, ()))
            waiting += [Branch(depth, link.child, link) for link in links]

    def way_up(self, frame: str) -> list[Link]:
        """Return the links from a frame to its root. In a loop, return each link once."""
        found: dict[str, Link] = {}
        while frame in self.links_of and frame not in found:
            found[frame] = self.links_of[frame][0]
            frame = found[frame].parent
        return list(found.values())

    @cached_property
    def _roots(self) -> dict[str, str]:
        """The root of each frame. In a loop, it is the frame that is first in the alphabet."""
        found: dict[str, str] = {}
        for frame in self.frames:
            way: dict[str, None] = {}
            name = frame
            while name in self.links_of and name not in found and name not in way:
                way[name] = None
                name = self.links_of[name][0].parent
            names = list(way)
            root = min(names[names.index(name) :]) if name in way else found.get(name, name)
            found.update(dict.fromkeys([*names, name], root))
        return found

    @cached_property
    def _trees(self) -> dict[str, list[str]]:
        found: dict[str, list[str]] = {}
        for frame in self.frames:
            found.setdefault(self.root(frame), []).append(frame)
        return found

    def root(self, frame: str) -> str:
        """Return the root of a frame's tree, or the frame itself if nobody has published it."""
        return self._roots.get(frame, frame)

    def loop_at(self, frame: str) -> list[str]:
        """Return the frames of the loop that a frame or its ancestors are in, or an empty list."""
        root = self.root(frame)
        return [link.child for link in self.way_up(root)] if root in self.links_of else []

    def loops(self) -> list[list[str]]:
        """Return each loop, beginning with the frame that is first in the alphabet."""
        return [self.loop_at(root) for root in sorted({*self._roots.values()} & {*self.links_of})]

    def tree(self, root: str) -> list[str]:
        """Return the frames with a root, sorted."""
        return self._trees.get(root, [])

    def links_between(self, first: str, second: str) -> list[Link] | None:
        """Return the links on the way between two frames, or None if there is no way."""
        up, down = self.way_up(first), self.way_up(second)
        ends = [first, *(link.parent for link in up)]
        other_ends = [second, *(link.parent for link in down)]
        others = set(other_ends)
        for count, frame in enumerate(ends):
            if frame in others:
                return [*up[:count], *reversed(down[: other_ends.index(frame)])]
        return None

    def joins(self, child: str, first: str, second: str) -> bool:
        """Return whether a child's parents are in the trees of two frames, which are different."""
        roots = {self.root(parent) for parent in self.parents(child)}
        return {self.root(first), self.root(second)} <= roots

    def missing_link(self, first: str, second: str) -> tuple[str, str]:
        """Return the parent and the child that would probably connect the trees of two frames.

        The child is the root of one tree. REP 105 says which tree is above the other.
        """
        upper, lower = self.root(first), self.root(second)
        if _rank(upper) > _rank(lower):
            upper, lower = lower, upper
        place = _rank(lower)
        above = [name for name in self.tree(upper) if _rank(name) < place]
        if not above and _rank(upper) == place < len(_USUAL_ORDER):  # odoms of two robots
            above = [_USUAL_ORDER[place - 1]]
        return max(above, key=_rank, default=upper), lower

    def similar_names(self, first: str, second: str) -> tuple[str, str] | None:
        """Return two frames of different trees that differ by a letter or two, or None."""
        roots = (self.root(first), self.root(second))
        for own, other in (roots, roots[::-1]):
            similar = nearest(own, self.tree(other))
            if similar is not None:
                return own, similar
        return None


def _rank(frame: str) -> int:
    """Return the place of a frame in REP 105's order, also for names such as `robot1/odom`."""
    name = frame.rpartition("/")[2]
    return _USUAL_ORDER.index(name) if name in _USUAL_ORDER else len(_USUAL_ORDER)


def _without_replaced(links: Sequence[Link], ended: Collection[Link]) -> list[Link]:
    """Leave out the links whose child has got another parent since they were heard."""
    by_child: dict[str, list[Link]] = {}
    for link in links:
        by_child.setdefault(link.child, []).append(link)

    def is_replaced(old: Link) -> bool:
        later = (new for new in by_child[old.child] if new.first_received_ns > old.last_received_ns)
        return any(not old.is_static or old in ended or _is_same_node(new, old) for new in later)

    return [link for link in links if not is_replaced(link)]


def _is_same_node(new: Link, old: Link) -> bool:
    return new.is_static and bool(new.publishers.keys() & old.publishers)
