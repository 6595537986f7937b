"""Check of bags that students handed in, or that a teacher has recorded."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

from zbot.bag.description import is_service_event, service_name
from zbot.bag.reader import Reader
from zbot.classroom.teacher.class_check import Verdict
from zbot.text.whole_number import whole_number
from zbot.time import S_TO_NS
from zbot.wire.tokens import EntityKind
from zbot_cli.errors import CommandError

if TYPE_CHECKING:
    from collections.abc import Collection, Sequence
    from pathlib import Path

    from zbot.classroom.teacher.expectation import Expectation
    from zbot.graph.snapshot import NamesAndTypes
    from zbot.wire.tokens import NodeToken

#: Keys that `zbot class record` adds to the metadata of a bag.
NUMBER_KEY, NAME_KEY = "student_number", "student_name"


def not_in_bag_error(verb: str) -> CommandError:
    """Return the error that a bag cannot show whether an expectation is met."""
    return CommandError(
        f"`{verb}` cannot be checked in a bag: a bag has only what was published, and calls"
    )


class _Recorded:
    """Topics and services in a bag."""

    def __init__(self, bag: Reader, timed: Collection[str]) -> None:
        self._topics: dict[str, str] = {}
        self._services: dict[str, str] = {}
        for information in bag.metadata.topics:
            name, type_name = information.topic.name, information.topic.type_name
            if is_service_event(name, type_name):
                self._services[service_name(name)] = type_name.removesuffix("_Event")
            elif information.message_count:
                self._topics[name] = type_name
        self.rates_hz = _rates_hz(bag, timed) if timed else {}

    @property
    def nodes(self) -> Sequence[NodeToken]:
        return ()

    def names_and_types(self, *kinds: EntityKind) -> NamesAndTypes:
        found = self._services if EntityKind.SERVICE in kinds else self._topics
        return [(name, [type_name]) for name, type_name in found.items()]


def check_bag(path: Path, expectations: Sequence[Expectation]) -> Verdict:
    """Return the verdict for a bag.

    If `zbot class record` has written the bag, the verdict has the number and name of the student.
    Otherwise the verdict has the number 0 and the name of the bag.

    Raises:
        CommandError: An expectation is not about publishers or services.
        BagNotFoundError: There is no file or folder with this path.
        BagReadError: The path is not a bag, or a part of the bag is damaged.
    """
    for expectation in expectations:
        if expectation.kind is EntityKind.NODE:
            raise not_in_bag_error("runs")
        if expectation.kind is EntityKind.SUBSCRIPTION:
            raise not_in_bag_error("subscribes")
    with Reader(path) as bag:
        recorded = _Recorded(
            bag, {expectation.name for expectation in expectations if expectation.has_rate}
        )
        facts = bag.metadata.custom_data
    problems = (expectation.problem(recorded, recorded.rates_hz) for expectation in expectations)
    return Verdict(
        whole_number(facts.get(NUMBER_KEY, ""), 3) or 0,
        facts.get(NAME_KEY) or path.name,
        tuple(filter(None, problems)),
    )


def _rates_hz(bag: Reader, topics: Collection[str]) -> dict[str, float]:
    """Return the mean rate of each topic with at least two messages."""
    counts: Counter[str] = Counter()
    first: dict[str, int] = {}
    last: dict[str, int] = {}
    for message in bag.messages(topics):
        counts[message.topic] += 1
        first.setdefault(message.topic, message.log_ns)
        last[message.topic] = message.log_ns
    return {
        name: (counts[name] - 1) * S_TO_NS / max(last[name] - first[name], 1)
        for name in first
        if counts[name] > 1
    }
