"""Measurement of topics for `zbot topic hz`, `bw` and `delay`. It prints figures every second.

Rates and bandwidths are measured without decoding. Messages are decoded only for `delay` and for
`hz --filter`.
"""

from __future__ import annotations

import math
import sys
import time
from functools import partial
from typing import TYPE_CHECKING, Any, Final, Protocol

from zbot_cli.commands.topic.problems import TopicProblems
from zbot_cli.domain.client import full_name, hidden_node
from zbot_cli.domain.kinds import TOPIC
from zbot_cli.domain.waiting import hint_if_silent, wait_for_type
from zbot_cli.errors import CommandError
from zbot_cli.input.domain_names import as_typed
from zbot_cli.output.listing import print_json

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from zbot.node.node import Node
    from zbot.qos import QoSProfile
    from zbot_cli.input.qos_options import QosOptions

TIME_RESET: Final = "time has reset, resetting counters"

_PERIOD_S = 1.0
_DEPTH = 1000  # a message that is lost in the queue would make the figures wrong
_NO_MESSAGES = "no new messages"


class Meter(Protocol):
    """Collector of the figures of one topic."""

    def add(self, message: Any) -> None:
        """Add a message. If `Measurement.decodes` is false, the message is bytes."""

    def figures(self) -> dict[str, float] | None:
        """Return the figures, or `None` if no message came since the last call."""


class Measurement(Protocol):
    """Quantity to measure. It makes a meter for each topic, and formats the meter's figures."""

    decodes: bool  #: whether the meters get decoded messages
    prints_subscription: bool  #: whether "Subscribed to" is printed for a single topic too
    compares_stamps: bool  #: whether stamps are compared with the node's time
    columns: tuple[str, ...]

    def meter(self, now_ns: Callable[[], int]) -> Meter:
        """Return a meter for one topic."""
        ...

    def text(self, figures: dict[str, float]) -> str:
        """Return the lines for one topic."""
        ...

    def cells(self, figures: dict[str, float]) -> list[str]:
        """Return a row of the table for several topics, without the name of the topic."""
        ...


def statistics(values: Sequence[float]) -> tuple[float, float, float, float]:
    """Return mean, minimum, maximum and population standard deviation."""
    mean = sum(values) / len(values)
    deviation = math.sqrt(sum((value - mean) ** 2 for value in values) / len(values))
    return mean, min(values), max(values), deviation


def measure(
    measurement: Measurement,
    topics: Sequence[str],
    qos: QosOptions,
    *,
    all_topics: bool,
    as_json: bool,
    use_sim_time: bool,
) -> None:
    """Measure topics until Ctrl-C. With `all_topics`, leave out those that cannot be measured.

    Raises:
        CommandError: `topics` is empty, and `all_topics` is false, or one of `topics` cannot be
            measured.
    """
    import zbot  # noqa: PLC0415 - makes the message packages importable

    with hidden_node("measure", use_sim_time=use_sim_time) as node:
        graph = node.context.graph.snapshot()
        names = [name for name, _ in graph.topics()] if all_topics else list(map(full_name, topics))
        if not names:
            raise CommandError("name a topic (zbot topic hz /chatter), or say --all")
        now_ns = time.monotonic_ns
        if use_sim_time or measurement.compares_stamps:
            now_ns = partial(_now_ns, node)
        meters = {name: measurement.meter(now_ns) for name in names}
        problems = TopicProblems([] if all_topics else names)
        for name, meter in meters.items():
            publishers = graph.publishers(name)
            if not as_json:
                _print_subscription(
                    measurement, name, known=bool(publishers), several=len(names) > 1
                )
            if measurement.decodes:
                with problems.of(name):
                    _subscribe(node, name, meter, qos.to_subscribe(publishers), problems)
            else:
                _subscribe_to_bytes(node, name, meter)
        report = _Report(measurement, meters, as_json=as_json)
        node.create_timer(_PERIOD_S, report.show)
        hint_if_silent(node, names, lambda: not report.started, is_measured=True)
        zbot.spin(node)


def _now_ns(node: Node) -> int:
    return node.get_clock().now().nanoseconds


def _print_subscription(measurement: Measurement, name: str, *, known: bool, several: bool) -> None:
    if not known:
        print(f"WARNING: topic [{as_typed(name)}] does not appear to be published yet")
    if measurement.prints_subscription or several:
        print(f"Subscribed to [{name}]")
    sys.stdout.flush()


def _subscribe(
    node: Node, name: str, meter: Meter, qos: QoSProfile, problems: TopicProblems
) -> None:
    def add(message: Any) -> None:
        with problems.of(name):
            meter.add(message)

    qos.depth = max(qos.depth, _DEPTH)
    message_type = TOPIC.class_of(wait_for_type(node, TOPIC, name))
    node.create_subscription(message_type, name, add, qos)


def _subscribe_to_bytes(node: Node, name: str, meter: Meter) -> None:
    # No type is needed, so topics of plain Zenoh programs are measured too.
    context = node.context
    key = context.dialect.topic_key(context.get_domain_id(), name)
    context.session.declare_subscriber(key, lambda sample: meter.add(sample.payload))


class _Report:
    def __init__(
        self, measurement: Measurement, meters: dict[str, Meter], *, as_json: bool
    ) -> None:
        self._measurement = measurement
        self._meters = meters
        self._as_json = as_json
        self.started = False  #: whether a message has arrived

    def show(self) -> None:
        found = {name: meter.figures() for name, meter in self._meters.items()}
        changed = {name: figures for name, figures in found.items() if figures is not None}
        if self._as_json:
            for name, figures in changed.items():
                print_json({"topic": name, **figures})
        elif len(self._meters) > 1:
            if changed:
                print(self._table(changed))
        elif changed:
            print(self._measurement.text(next(iter(changed.values()))))
        elif self.started:
            print(_NO_MESSAGES)
        self.started = self.started or bool(changed)
        sys.stdout.flush()

    def _table(self, changed: dict[str, dict[str, float]]) -> str:
        rows = [[name, *self._measurement.cells(figures)] for name, figures in changed.items()]
        columns = list(zip(self._measurement.columns, *rows, strict=True))
        widths = [max(map(len, column)) for column in columns]
        head = "   ".join(
            name.center(width)
            for name, width in zip(self._measurement.columns, widths, strict=True)
        )
        lines = [
            "   ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True))
            for row in rows
        ]
        return "\n".join((head.rstrip(), "=" * len(head), *lines, ""))
