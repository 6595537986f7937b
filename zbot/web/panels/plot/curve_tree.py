"""Tree of the topics and numeric fields that a plot can show."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

Branch = dict[str, Any]


def curve_tree(fields: Mapping[str, Iterable[str]]) -> list[Branch]:
    """Return the branches for `ui.tree`, with a branch for each topic.

    The id of a leaf is the name of its curve, e.g. `/turtle1/pose.x`. A topic without known numbers
    is a leaf too. Its id is the name of the topic, which means all numbers of its first message.

    Args:
        fields: The paths of each topic's numbers, e.g. `linear.x` and `covariance[0]`.
    """
    topics = []
    for topic, paths in fields.items():
        top: Branch = {"id": topic, "label": topic}
        for path in paths:
            _put(top, path, f"{topic}.{path}")
        topics.append(top)
    return topics


def _put(branch: Branch, path: str, name: str) -> None:
    parts = re.findall(r"[^.\[]+|\[\d+\]", path)
    for part in parts[:-1]:
        branch = _child(branch, part, f"{branch['id']}/{part}")
    _child(branch, parts[-1], name)


def _child(branch: Branch, label: str, key: str) -> Branch:
    children: list[Branch] = branch.setdefault("children", [])
    if children and children[-1]["label"] == label:  # the fields of a child follow each other
        return children[-1]
    children.append({"id": key, "label": label})
    return children[-1]
