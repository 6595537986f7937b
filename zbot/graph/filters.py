"""What a picture of the graph leaves out, and what it draws as one: rqt_graph's choices.

Pure: names in, yes or no out.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

from zbot.errors import ZbotError
from zbot.names import is_hidden

if TYPE_CHECKING:
    from collections.abc import Callable

__all__ = ["UNGROUPED", "Filters", "Grouping", "InvalidFilterError", "compile_filter"]

# As rqt_graph tells a name from a regular expression.
_PLAIN = re.compile(r"[a-zA-Z0-9_/]+")
# rqt_graph's quiet names, but whole: it looks for them anywhere in a name, and so loses a student's
# `/clock_face` and `/monitor_robot`. Of its list, `/monitor` and `/clock` may be a student's node.
_TOOLS = re.compile(
    r".*/(rqt|rviz)[^/]*|.*/(diag_agg|runtime_logger|pr2_dashboard|cpu_monitor|hd_monitor|rxloggerlevel)"
)
_DEBUG_TOPICS = frozenset({"rosout", "statistics", "clock", "time"})
TF_TOPICS = frozenset({"/tf", "/tf_static"})
_ACTION_PART = "/_action/"


class InvalidFilterError(ZbotError, ValueError):
    """A filter has a part that is no regular expression.

    Attributes:
        pattern: That part.
    """

    def __init__(self, pattern: str, reason: str) -> None:
        self.pattern = pattern
        super().__init__(
            f"invalid filter {pattern!r}: {reason}; write names or regular expressions with commas"
            " between them, and - before those to leave out: /robot.*,-/robot_2"
        )


@dataclass(frozen=True)
class Filters:
    """What is left out."""

    debug: bool = True  #: nodes of rqt and rviz; /rosout, /statistics, /clock
    tf: bool = False  #: transforms
    params: bool = True  #: /parameter_events
    dead_sinks: bool = False  #: topics without subscriptions
    leaf_topics: bool = False  #: topics with a single connection
    actions: bool = False  #: actions, and the topics of theirs
    hidden: bool = True  #: names with a part that begins with an underscore
    nodes: str = "/"  #: names and regular expressions of nodes, `-` before those to leave out
    topics: str = "/"  #: likewise of topics

    def shows_node(self, name: str) -> bool:
        """Whether a node is shown, whatever `nodes` says."""
        if self.debug and _TOOLS.fullmatch(name):
            return False
        return not (self.hidden and is_hidden(name))

    def shows_topic(self, name: str) -> bool:
        """Whether a topic is shown, whatever `topics` says."""
        last = name.rpartition("/")[2]
        return not (
            (self.debug and last in _DEBUG_TOPICS)
            or (self.tf and name in TF_TOPICS)
            or (self.params and last == "parameter_events")
            or (self.actions and _ACTION_PART in name)
            # An action's topics have a hidden name, but they are why two nodes belong together.
            or (self.hidden and is_hidden(name) and _ACTION_PART not in name)
        )


@dataclass(frozen=True)
class Grouping:
    """What is drawn as one."""

    namespaces: int = 2  #: how many levels of namespaces get a frame; 0 for none
    actions: bool = True  #: an action is one box
    tf: bool = True  #: /tf and /tf_static are one box
    images: bool = True  #: an image and its compressed forms are one box


UNGROUPED = Grouping(namespaces=0, actions=False, tf=False, images=False)


def compile_filter(text: str) -> Callable[[str], bool]:
    """Return whether a name passes a filter, as rqt_graph reads it.

    Parts are separated by commas. A part of letters, digits, `_` and `/` is a whole name, any other
    is a regular expression that must match from the beginning. `-` before a part leaves its names
    out. Nothing, or `/`, includes all.

    Raises:
        InvalidFilterError: A part is no regular expression.
    """
    parts = [part.strip() for part in text.split(",")]
    excludes = [_matcher(part[1:]) for part in parts if part.startswith("-")]
    wanted = [part for part in parts if part and not part.startswith("-")]
    includes = [] if wanted == ["/"] else [_matcher(part) for part in wanted]

    def passes(name: str) -> bool:
        is_included = not includes or any(one(name) for one in includes)
        return is_included and not any(one(name) for one in excludes)

    return passes


def _matcher(part: str) -> Callable[[str], bool]:
    if _PLAIN.fullmatch(part):
        return lambda name: name == part
    if not part:
        return lambda _: False  # a lone "-", while somebody types
    try:
        pattern = re.compile(part)
    except re.error as exc:
        raise InvalidFilterError(part, str(exc)) from exc
    return lambda name: pattern.match(name) is not None
