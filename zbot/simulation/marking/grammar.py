"""Grammar of the goals in a world.

These are examples of goals:

    reaches (3, 2) within 60 s
    visits exit, (1, 2) and box1
    touches nothing
    follows the wall for 5 m
    stops within 0.3 m of an obstacle

`and` joins several goals. Between them may be expectations about topics and nodes, e.g. `publishes
geometry_msgs/Twist on /cmd_vel at >= 5 Hz`. This module does not use the network.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, NamedTuple

from zbot.classroom.errors import ClassValueError
from zbot.classroom.teacher.expectation import Expectation, parse_expectations
from zbot.errors.suggestion import did_you_mean
from zbot.simulation.marking.goals import (
    FollowsWall,
    Goal,
    Reaches,
    StopsNear,
    Target,
    TouchesNothing,
    Visits,
)

if TYPE_CHECKING:
    from collections.abc import Mapping

    Places = Mapping[str, tuple[float, float]]

DEFAULT_LIMIT_S = 60.0
_LONGEST_S, _FARTHEST_M = 3600.0, 1000.0
_MOST_PARTS, _MOST_TEXT = 50, 10_000
_NUMBER = r"[0-9]{1,6}(?:\.[0-9]{1,6})?"
_PLACE = rf"\(\s?[+-]?{_NUMBER}\s?,\s?[+-]?{_NUMBER}\s?\)|[A-Za-z]\w{{0,60}}"
_LIMIT = rf"(?: within (?P<limit>{_NUMBER}) s)?"
_FLAGS = re.IGNORECASE | re.ASCII
_FORMS = {
    "reaches": re.compile(rf"reaches (?P<place>{_PLACE}){_LIMIT}", _FLAGS),
    "visits": re.compile(
        rf"visits (?P<places>(?:{_PLACE})(?:(?:,| and|, and) (?:{_PLACE}))*?){_LIMIT}", _FLAGS
    ),
    "touches": re.compile(rf"touches nothing{_LIMIT}", _FLAGS),
    "follows": re.compile(rf"follows (?:the|a) wall(?: for (?P<way>{_NUMBER}) m)?{_LIMIT}", _FLAGS),
    "stops": re.compile(
        rf"stops within (?P<gap>{_NUMBER}) m of (?:an obstacle|a wall|the wall){_LIMIT}", _FLAGS
    ),
}
_EXAMPLES = {
    "reaches": "reaches (3, 2) within 60 s",
    "visits": "visits (1, 0), (3, 2) and (0, 0) within 60 s",
    "touches": "touches nothing",
    "follows": "follows the wall for 5 m within 60 s",
    "stops": "stops within 0.3 m of an obstacle",
}
_TOPIC_VERBS = ("publishes", "subscribes", "serves", "runs")


class Task(NamedTuple):
    """What a program has to do."""

    goals: list[Goal]
    expectations: list[Expectation]

    @property
    def limit_s(self) -> float:
        """The time of the world after which all is decided."""
        return max((goal.limit_s for goal in self.goals), default=10.0)


def parse_task(text: str, places: Places) -> Task:
    """Return the goals and the expectations that a text contains.

    Args:
        text: Parts that are joined by `and`.
        places: The names of places in the world.

    Raises:
        ClassValueError: A part is neither a goal nor an expectation.
    """
    goals: list[Goal] = []
    expectations: list[Expectation] = []
    for part in _parts(text):
        verb = part.partition(" ")[0].lower()
        if verb in _FORMS:
            goals.append(_goal(verb, part, places))
        elif verb in _TOPIC_VERBS:
            expectations += parse_expectations(part)
        else:
            known = [*_FORMS, *_TOPIC_VERBS]
            hint = did_you_mean(verb, known) or f"it must begin with {', '.join(known)}"
            raise _error(part, hint, "reaches")
    return Task(goals, expectations)


def _parts(text: str) -> list[str]:
    """Split a text at `and`. The places of `visits` stay together."""
    if len(text) > _MOST_TEXT:
        raise ClassValueError(f"the text of the goals has more than {_MOST_TEXT} characters")
    parts: list[str] = []
    for word in re.split(r" and |; ?", " ".join(text.split())):
        is_place = re.fullmatch(rf"(?:{_PLACE})(?:, (?:{_PLACE}))*{_LIMIT}", word, _FLAGS)
        if parts and is_place and parts[-1].lower().startswith("visits "):
            parts[-1] += f" and {word}"
        else:
            parts.append(word)
    if len(parts) > _MOST_PARTS:
        raise ClassValueError(f"there are {len(parts)} goals: the limit is {_MOST_PARTS}")
    return parts


def _error(part: str, reason: str, verb: str) -> ClassValueError:
    return ClassValueError(
        f"cannot check {part[:200]!r}: {reason}", hint=f'write it like "{_EXAMPLES[verb]}"'
    )


def _goal(verb: str, part: str, places: Places) -> Goal:
    found = _FORMS[verb].fullmatch(part)
    if found is None:
        raise _error(part, "the words are not those of a goal", verb)
    limit_s = float(found["limit"] or DEFAULT_LIMIT_S)
    if not 0 < limit_s <= _LONGEST_S:
        raise _error(part, f"the time must be above 0 and at most {_LONGEST_S:g} s", verb)
    if verb == "reaches":
        return Reaches(part, limit_s, _target(part, found["place"], places))
    if verb == "visits":
        names = re.findall(_PLACE, re.sub(r",? and ", ", ", found["places"]), _FLAGS)
        return Visits(part, limit_s, [_target(part, name, places) for name in names])
    if verb == "follows":
        return FollowsWall(part, limit_s, float(found["way"] or 3))
    if verb == "stops":
        return StopsNear(part, limit_s, float(found["gap"]))
    return TouchesNothing(part, limit_s)


def _target(part: str, name: str, places: Places) -> Target:
    if name.startswith("("):
        x, y = (float(number) for number in name.strip("()").split(","))
        if max(abs(x), abs(y)) > _FARTHEST_M:
            raise _error(part, f"a place is at most {_FARTHEST_M:g} m away", "reaches")
        return Target(f"({x:g}, {y:g})", x, y)
    if name not in places:
        known = did_you_mean(name, places) or (
            f"its places are {', '.join(sorted(places))}" if places else "it has no named places"
        )
        raise _error(part, f"the world has no place '{name}'; {known}", "reaches")
    return Target(name, *places[name])
