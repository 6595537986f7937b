"""Drawing of a tree of frames, as DOT for Graphviz and as SVG."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from html import escape
from typing import Any

from zbot.errors import WrongValueError
from zbot.text.yaml_reader import YamlError, read_yaml

_WIDTH, _HEIGHT, _GAP_X, _GAP_Y = 230, 74, 16, 46
_EMPTY = "No tf data received"
_FACTS = (
    ("Broadcaster", "broadcaster"),
    ("Average rate", "rate"),
    ("Buffer length", "buffer_length"),
    ("Most recent transform", "most_recent_transform"),
    ("Oldest transform", "oldest_transform"),
)


def frame_tree_error(reason: str) -> WrongValueError:
    """Return the error that the list of frames cannot be read."""
    return WrongValueError(f"the list of frames cannot be read: {reason}")


@dataclass(frozen=True)
class FrameTree:
    """Frames by name, with facts about the transform from the parent of each frame."""

    frames: dict[str, dict[str, Any]]
    recorded_s: float  #: the time of the drawing

    @classmethod
    def of(cls, yaml: str, recorded_s: float) -> FrameTree:
        """Return the tree in a text of `Buffer.all_frames_as_yaml`.

        Raises:
            WrongValueError: The text has another form, e.g. because a frame's name has a quote.
        """
        try:
            found = read_yaml(yaml) or {}
        except YamlError as error:
            raise frame_tree_error(str(error)) from None
        if not isinstance(found, dict):
            raise frame_tree_error("it has no frames")
        keys = ("parent", *(key for _, key in _FACTS))
        for name, facts in found.items():
            if not isinstance(facts, dict) or any(key not in facts for key in keys):
                raise frame_tree_error(f"a fact about the frame {str(name)[:40]!r} is missing")
            facts["parent"] = str(facts["parent"])
        return cls({str(name): facts for name, facts in found.items()}, recorded_s)

    @property
    def roots(self) -> list[str]:
        """The frames without a parent. Several roots mean several separate trees."""
        parents = [frame["parent"] for frame in self.frames.values()]
        return list(dict.fromkeys(parent for parent in parents if parent not in self.frames))

    def children(self, name: str) -> list[str]:
        """Return the frames whose parent is the frame `name`."""
        return self._children.get(name, [])

    @cached_property
    def _children(self) -> dict[str, list[str]]:
        """The children of each frame that has some. One search for each frame would take long."""
        found: dict[str, list[str]] = {}
        for frame in sorted(self.frames):
            found.setdefault(self.frames[frame]["parent"], []).append(frame)
        return found

    def to_dot(self) -> str:
        """Return the text for Graphviz."""
        if not self.frames:
            return f'digraph G {{ "{_EMPTY}" }}\n'
        lines = ["digraph G {"]
        for name, facts in self.frames.items():
            label = "".join(f"{title}: {_dot(facts[key])}\\n" for title, key in _FACTS)
            lines.append(f'"{_dot(facts["parent"])}" -> "{_dot(name)}"[label=" {label}"];')
        lines += [
            "edge [style=invis];",
            'subgraph cluster_legend { style=bold; color=black; label="view_frames Result";',
            f'"Recorded at time: {self.recorded_s}"[shape=plaintext];',
            f'}}->"{_dot(self.roots[0])}";' if self.roots else "}",
            "}",
        ]
        return "\n".join(lines) + "\n"

    def to_svg(self) -> str:
        """Return a drawing: roots on top, each frame below its parent."""
        places: dict[str, tuple[float, int]] = {}
        column = 0.0
        for root in self.roots:
            column = self._place(root, 0, column, places)
        width = round(max(column, 1) * (_WIDTH + _GAP_X)) + _GAP_X
        rows = 1 + max((row for _, row in places.values()), default=0)
        parts = [self._line(name, places) for name in self.frames if name in places]
        parts += [self._box(name, place) for name, place in places.items()]
        if not places:
            parts = [_text(_GAP_X, 30, _EMPTY)]
        height = rows * (_HEIGHT + _GAP_Y) + _GAP_Y
        head = f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
        style = 'font-family="sans-serif" font-size="11">'
        return f"{head}{style}\n" + "\n".join(parts) + "\n</svg>\n"

    def _place(
        self, root: str, row: int, column: float, places: dict[str, tuple[float, int]]
    ) -> float:
        """Place a root, and all frames below the root. Return the next free column.

        Each frame is above the middle of its children.
        """
        # This is not recursive, because a chain of frames may be too long for recursion.
        waiting: list[tuple[str, int, bool]] = [(root, row, False)]
        while waiting:
            name, depth, is_done = waiting.pop()
            children = self.children(name)
            if is_done:
                found = [places[child][0] for child in children]
                places[name] = ((found[0] + found[-1]) / 2, depth)
            elif not children:
                places[name] = (column, depth)
                column += 1
            else:
                waiting.append((name, depth, True))
                waiting += [(child, depth + 1, False) for child in reversed(children)]
        return column

    def _line(self, name: str, places: dict[str, tuple[float, int]]) -> str:
        (x, y), (px, py) = (
            _corner(places[name]),
            _corner(places[self.frames[name]["parent"]]),
        )
        middle = _WIDTH / 2
        ends = f'x1="{px + middle}" y1="{py + _HEIGHT}" x2="{x + middle}" y2="{y}"'
        return f'<line {ends} stroke="#888"/>'

    def _box(self, name: str, place: tuple[float, int]) -> str:
        x, y = _corner(place)
        size = f'width="{_WIDTH}" height="{_HEIGHT}" rx="5"'
        lines = [f'<rect x="{x}" y="{y}" {size} fill="#f4f6fa" stroke="#467"/>']
        lines.append(_text(x + 8, y + 17, name, 'font-weight="bold" font-size="13"'))
        facts = self.frames.get(name)
        texts = (
            ()
            if facts is None
            else (
                f"rate {facts['rate']} Hz, buffer {facts['buffer_length']} s",
                f"latest {facts['most_recent_transform']}",
                f"from {facts['broadcaster']}",
            )
        )
        lines += [_text(x + 8, y + 33 + 14 * row, text) for row, text in enumerate(texts)]
        return "\n".join(lines)


def _corner(place: tuple[float, int]) -> tuple[float, float]:
    column, row = place
    return _GAP_X + column * (_WIDTH + _GAP_X), _GAP_Y / 2 + row * (_HEIGHT + _GAP_Y)


def _text(x: float, y: float, text: str, style: str = "") -> str:
    return f'<text x="{x}" y="{y}" {style}>{escape(text[:60])}</text>'


def _dot(value: object) -> str:
    return str(value).replace("\\", "\\\\").replace('"', '\\"').replace("\n", " ")
