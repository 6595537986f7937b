"""Parser and check of expectations about a student's programs.

These are examples of expectations:

    publishes std_msgs/String on /student_id at >= 1 Hz
    subscribes geometry_msgs/Twist on /cmd_vel
    serves example_interfaces/AddTwoInts on /add_two_ints
    runs /talker

`and` joins several expectations. This module does not use the network.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

from zbot.classroom.errors import ClassValueError
from zbot.errors import InvalidNameError, shortened
from zbot.errors.suggestion import did_you_mean, question, similar_names
from zbot.graph.snapshot import full_names
from zbot.names import validate_full_topic_name
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from zbot.graph.snapshot import NamesAndTypes
    from zbot.wire.tokens import NodeToken

#: Accepted relative deviation from a rate, because a timer of 1 Hz is sometimes late.
TOLERANCE = 0.05

_KINDS = {
    "publishes": EntityKind.PUBLISHER,
    "subscribes": EntityKind.SUBSCRIPTION,
    "serves": EntityKind.SERVICE,
}
_USE = re.compile(
    r"(?P<verb>publishes|subscribes|serves) (?P<type>\S+) on (?P<name>\S+)"
    r"(?: at (?P<sign>>=|<=|>|<|=)? ?(?P<rate>[0-9]+(?:\.[0-9]+)?) ?Hz)?",
    re.IGNORECASE | re.ASCII,
)
_RUN = re.compile(r"runs (?P<name>\S+)", re.IGNORECASE | re.ASCII)
_TYPE = re.compile(r"([A-Za-z]\w*)/(?:(?:msg|srv|action)/)?([A-Za-z]\w*)", re.ASCII)


def expectation_error(text: str, reason: str) -> ClassValueError:
    """Return the error that a text is not an expectation."""
    hint = 'write it like "publishes std_msgs/String on /student_id at >= 1 Hz"'
    return ClassValueError(f"cannot check {shortened(text, 200)}: {reason}", hint=hint)


class Observed(Protocol):
    """What was seen of a student's programs: a graph, or a bag."""

    @property
    def nodes(self) -> Sequence[NodeToken]:
        """The nodes."""
        ...

    def names_and_types(self, *kinds: EntityKind) -> NamesAndTypes:
        """Return the names and types of endpoints."""
        ...


@dataclass(frozen=True)
class Expectation:
    """One endpoint or node that a student's programs should have."""

    kind: EntityKind  #: `NODE` for a node that should run
    name: str  #: name of the topic, service or node
    type_name: str = ""  #: e.g. `std_msgs/msg/String`; empty for a node
    sign: str = ""  #: `>=`, `<=`, `>`, `<` or `=`, or empty if no rate is expected
    rate_hz: float = 0.0

    @property
    def has_rate(self) -> bool:
        """Whether a rate is expected, so that messages have to be counted."""
        return bool(self.sign)

    def problem(self, observed: Observed, rates_hz: Mapping[str, float]) -> str:
        """Return the problem if the expectation is not met. Return an empty string if it is met.

        Args:
            observed: The graph of the student's domain, or a bag.
            rates_hz: Measured rates by topic.
        """
        if self.kind is EntityKind.NODE:
            return _node_problem(self.name, full_names(observed.nodes))
        found = dict(observed.names_and_types(self.kind))
        if self.name not in found:
            return _missing(self.kind, self.name, sorted(found))
        types = found[self.name]
        if self.type_name not in types:
            return f"{self.name} has type {', '.join(types)}, not {self.type_name}"
        return self._rate_problem(rates_hz.get(self.name, 0.0)) if self.has_rate else ""

    def _rate_problem(self, rate_hz: float) -> str:
        low, high = self.rate_hz * (1 - TOLERANCE), self.rate_hz * (1 + TOLERANCE)
        is_right = {
            ">=": rate_hz >= low,
            ">": rate_hz > self.rate_hz,
            "<=": rate_hz <= high,
            "<": rate_hz < self.rate_hz,
            "=": low <= rate_hz <= high,
        }[self.sign]
        if is_right:
            return ""
        if rate_hz == 0:
            return f"{self.name} has a publisher, but no message arrived"
        return f"{self.name} has {rate_hz:.2f} Hz, not {self.sign} {self.rate_hz:g} Hz"


def parse_expectations(text: str) -> list[Expectation]:
    """Return the expectations that a text contains.

    Raises:
        ClassValueError: A part of the text is not an expectation.
    """
    words = " ".join(text.split())  # so no pattern has to try many numbers of spaces
    return [_parse(part.strip()) for part in re.split(r" and |;", words)]


def _parse(text: str) -> Expectation:
    match = _RUN.fullmatch(text)
    if match is not None:
        return Expectation(EntityKind.NODE, _name(text, match["name"]))
    match = _USE.fullmatch(text)
    if match is None:
        raise expectation_error(text, _reason(text))
    verb = match["verb"].lower()
    if match["rate"] and verb != "publishes":
        raise expectation_error(text, "only `publishes` can have a rate")
    return Expectation(
        _KINDS[verb],
        _name(text, match["name"]),
        _type_name(text, match["type"], "srv" if verb == "serves" else "msg"),
        (match["sign"] or ">=") if match["rate"] else "",
        float(match["rate"] or 0),
    )


def _reason(text: str) -> str:
    verb = text.split(" ", maxsplit=1)[0].lower()
    if verb not in {*_KINDS, "runs"}:
        rule = "it must begin with publishes, subscribes, serves or runs"
        return did_you_mean(verb, [*_KINDS, "runs"]) or rule
    if " on " not in f"{text} ":
        return "`on /name` is missing"
    return "the words after the name must be like `at >= 1 Hz`"


def _name(text: str, name: str) -> str:
    full = name if name.startswith("/") else f"/{name}"
    try:
        validate_full_topic_name(full)
    except InvalidNameError as exc:
        raise expectation_error(text, exc.error_msg) from exc
    return full


def _type_name(text: str, name: str, kind: str) -> str:
    match = _TYPE.fullmatch(name)
    if match is None:
        raise expectation_error(text, f"{shortened(name)} is not a type such as std_msgs/String")
    return f"{match[1]}/{kind}/{match[2]}"


def _node_problem(name: str, running: list[str]) -> str:
    if name in running:
        return ""
    return f"{name} does not run{did_you_mean(name, running, before='; ')}"


def _missing(kind: EntityKind, name: str, present: list[str]) -> str:
    what = {
        EntityKind.PUBLISHER: "nobody publishes",
        EntityKind.SUBSCRIPTION: "nobody subscribes to",
        EntityKind.SERVICE: "nobody serves",
    }[kind]
    near = similar_names(name, present) or _same_letters(name, present)
    return f"{what} {name}{question(near, '; ')}"


def _same_letters(name: str, present: list[str]) -> list[str]:
    """Return a name that differs only in case, underscores or namespace, if there is one."""

    def bare(full: str) -> str:
        return full.rpartition("/")[2].replace("_", "").lower()

    return [other for other in present if bare(other) == bare(name)][:1]
