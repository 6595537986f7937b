"""Filters and grouping of the drawn graph. The options are the same as in rqt_graph."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

from zbot.errors import ZbotError
from zbot.interfaces.text_pattern import PatternError, RegularExpression
from zbot.names import ACTION_PART, is_hidden

if TYPE_CHECKING:
    from collections.abc import Callable

__all__ = ["UNGROUPED", "Filters", "Grouping", "InvalidFilterError", "compile_filter"]

_MOST_CHARACTERS = 2_000
# rqt_graph treats a text of these characters as a name. Any other text is a regular expression.
_PLAIN = re.compile(r"[a-zA-Z0-9_/]+")
# Names that rqt_graph hides as "quiet". zbot compares whole names. rqt_graph searches for parts of
# names, so it also hides nodes like `/clock_face` and `/monitor_robot`. This list does not contain
# `/monitor` and `/clock` of rqt_graph, because students often use these names for nodes.
_TOOLS = re.compile(
    r".*/(rqt|rviz)[^/]*|.*/(diag_agg|runtime_logger|pr2_dashboard|cpu_monitor|hd_monitor|rxloggerlevel)"
)
_DEBUG_TOPICS = frozenset({"rosout", "statistics", "clock", "time"})
TF_TOPICS = frozenset({"/tf", "/tf_static"})


class InvalidFilterError(ZbotError, ValueError):
    """A part of a filter is not a regular expression, or the filter is too long.

    Attributes:
        pattern: The wrong part.
    """

    def __init__(self, pattern: str, reason: str) -> None:
        self.pattern = pattern
        super().__init__(
            f"invalid filter {pattern!r}: {reason}; write names or regular expressions, separated"
            " by commas, and - before each one to leave out: /robot.*,-/robot_2"
        )


@dataclass(frozen=True)
class Filters:
    """Choice of nodes and topics. Each switch that is True leaves out the names in its comment."""

    debug: bool = True  #: nodes of rqt and rviz; /rosout, /statistics, /clock
    tf: bool = False  #: transforms
    params: bool = True  #: /parameter_events
    dead_sinks: bool = False  #: topics without subscriptions
    leaf_topics: bool = False  #: topics with a single connection
    actions: bool = False  #: actions, with their topics
    hidden: bool = True  #: names with a part that begins with an underscore
    nodes: str = "/"  #: filter for names of nodes, as in `compile_filter`
    topics: str = "/"  #: filter for names of topics, as in `compile_filter`

    def shows_node(self, name: str) -> bool:
        """Return whether the switches allow a node. This method ignores the filter `nodes`."""
        if self.debug and _TOOLS.fullmatch(name):
            return False
        return not (self.hidden and is_hidden(name))

    def shows_topic(self, name: str) -> bool:
        """Return whether the switches allow a topic. This method ignores the filter `topics`."""
        last = name.rpartition("/")[2]
        return not (
            (self.debug and last in _DEBUG_TOPICS)
            or (self.tf and name in TF_TOPICS)
            or (self.params and last == "parameter_events")
            or (self.actions and ACTION_PART in name)
            # Topics of actions have hidden names. They stay, because they show connected nodes.
            or (self.hidden and is_hidden(name) and ACTION_PART not in name)
        )


@dataclass(frozen=True)
class Grouping:
    """Choice of topics that are drawn as one box, and of namespaces that get a frame."""

    namespaces: int = 2  #: the number of namespace levels that get a frame
    actions: bool = True  #: an action is one box
    tf: bool = True  #: /tf and /tf_static are one box
    images: bool = True  #: an image and its compressed forms are one box


UNGROUPED = Grouping(namespaces=0, actions=False, tf=False, images=False)


def compile_filter(text: str) -> Callable[[str], bool]:
    """Return a function that returns whether a filter allows a name, as in rqt_graph.

    Commas separate the parts of a filter. A part of letters, digits, `_` and `/` is a whole name.
    Any other part is a regular expression that must match from the beginning of a name. If `-` is
    before a part, the names of this part are left out. An empty filter and the filter `/` include
    all names. Regular expressions are those of `RegularExpression`, so no name takes long.

    Raises:
        InvalidFilterError: A part is not a regular expression, or the filter is too long.
    """
    if len(text) > _MOST_CHARACTERS:
        raise InvalidFilterError(
            f"{text[:20]}...", f"it has more than {_MOST_CHARACTERS:,} characters"
        )
    parts = [part.strip() for part in text.split(",")]
    excludes = [_matcher(part[1:]) for part in parts if part.startswith("-")]
    wanted = [part for part in parts if part and not part.startswith("-")]
    includes = [] if wanted == ["/"] else [_matcher(part) for part in wanted]

    def passes(name: str) -> bool:
        is_included = not includes or any(matches(name) for matches in includes)
        return is_included and not any(matches(name) for matches in excludes)

    return passes


def _matcher(part: str) -> Callable[[str], bool]:
    if _PLAIN.fullmatch(part):
        return lambda name: name == part
    if not part:
        return lambda _: False  # the user has typed only "-" so far
    try:
        return RegularExpression(part, is_whole=False).matches
    except PatternError as exc:
        raise InvalidFilterError(part, str(exc)) from exc
