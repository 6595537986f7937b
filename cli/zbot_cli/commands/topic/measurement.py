"""`zbot topic hz`, `bw` and `delay`: figures every second, for one topic or several.

Rates and bandwidths are taken from the bytes as they come: nothing is decoded, unless a filter
asks.
"""

from __future__ import annotations

import math
import sys
import time
from collections import deque
from functools import partial
from typing import TYPE_CHECKING, Any, Protocol

from zbot.errors import ZbotError
from zbot_cli.domain.client import full_name, hidden_node
from zbot_cli.output.listing import print_json

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from zbot.node.node import Node
    from zbot.qos import QoSProfile
    from zbot_cli.input.qos_options import Choice

_PERIOD_S = 1.0
_DEPTH = 1000  # a figure is wrong if messages are dropped here
_NO_NEWS = "no new messages"
_RESET = "time has reset, resetting counters"


class MissingHeaderError(ZbotError):
    """Delays are measured on a topic whose messages carry no time."""

    def __init__(self) -> None:
        super().__init__("msg does not have header")


class NoTopicError(ZbotError):
    """Nothing was named that could be measured."""

    def __init__(self) -> None:
        super().__init__("name a topic, or say --all: zbot topic hz /chatter")


class Meter(Protocol):
    """Collects figures of one topic and prints them."""

    def add(self, message: Any) -> None:
        """Take a message."""

    def figures(self) -> dict[str, float] | None:
        """Return the figures, or `None` if nothing came since the last time."""


class Kind(Protocol):
    """What is measured: how to make a meter, and how its figures look."""

    decodes: bool
    announces: bool
    reads_stamps: bool  #: whether the node's clock is needed, for that is what stamps are of
    columns: tuple[str, ...]

    def meter(self, now_ns: Callable[[], int]) -> Meter:
        """Return a meter for one topic."""
        ...

    def text(self, figures: dict[str, float]) -> str:
        """Return the lines for one topic."""
        ...

    def cells(self, figures: dict[str, float]) -> list[str]:
        """Return a row of the table for several topics."""
        ...


def spread(values: Sequence[float]) -> tuple[float, float, float, float]:
    """Return mean, smallest, largest and population standard deviation."""
    mean = sum(values) / len(values)
    deviation = math.sqrt(sum((value - mean) ** 2 for value in values) / len(values))
    return mean, min(values), max(values), deviation


class _IntervalMeter:
    def __init__(
        self, window: int, accepts: Callable[[Any], bool] | None, now_ns: Callable[[], int]
    ) -> None:
        self._intervals: deque[float] = deque(maxlen=max(window, 1))
        self._accepts = accepts
        self._now_ns = now_ns
        self._last: int | None = None
        self._news = False

    def add(self, message: Any) -> None:
        if self._accepts is not None and not self._accepts(message):
            return
        now = self._now_ns()
        if now == 0:  # simulated time has not begun
            return
        if self._last is not None and now >= self._last:
            self._intervals.append((now - self._last) / 1e9)
            self._news = True
        elif self._last is not None:  # a simulation was started again
            print(_RESET, file=sys.stderr, flush=True)
            self._intervals.clear()
            self._news = False
        self._last = now

    def figures(self) -> dict[str, float] | None:
        intervals = list(self._intervals)  # Zenoh's thread goes on adding
        if not (self._news and intervals):
            return None
        self._news = False
        mean, low, high, deviation = spread(intervals)
        return {
            "rate": 1 / mean if mean > 0 else math.inf,
            "min": low,
            "max": high,
            "std_dev": deviation,
            "window": len(intervals),
        }


class Rates:
    """How often messages come: `zbot topic hz`."""

    announces = reads_stamps = False
    columns: tuple[str, ...] = ("topic", "rate", "min_delta", "max_delta", "std_dev", "window")

    def __init__(self, window: int, filter_expression: str | None = None) -> None:
        self._window = window
        self._filter = filter_expression
        self.decodes = filter_expression is not None

    def meter(self, now_ns: Callable[[], int]) -> Meter:
        """Return a meter for one topic."""
        accepts = None
        if self._filter is not None:
            from zbot_cli.input.filter import Filter  # noqa: PLC0415 - seldom used

            accepts = Filter(self._filter).accepts
        return _IntervalMeter(self._window, accepts, now_ns)

    def text(self, figures: dict[str, float]) -> str:
        """Return the two lines of ros2."""
        return (
            f"average rate: {figures['rate']:.3f}\n"
            f"\tmin: {figures['min']:.3f}s max: {figures['max']:.3f}s "
            f"std dev: {figures['std_dev']:.5f}s window: {figures['window']}"
        )

    def cells(self, figures: dict[str, float]) -> list[str]:
        """Return a row of the table, without the topic."""
        return [
            f"{figures['rate']:.3f}",
            f"{figures['min']:.3f}",
            f"{figures['max']:.3f}",
            f"{figures['std_dev']:.5f}",
            f"{figures['window']}",
        ]


class _SizeMeter:
    def __init__(self, window: int, now_ns: Callable[[], int]) -> None:
        self._times: deque[int] = deque(maxlen=max(window, 2))
        self._sizes: deque[int] = deque(maxlen=max(window, 2))
        self._now_ns = now_ns

    def add(self, message: Any) -> None:
        now = self._now_ns()
        if now == 0:  # simulated time has not begun
            return
        if self._times and now < self._times[-1]:  # a simulation was started again
            print(_RESET, file=sys.stderr, flush=True)
            self._times.clear()
            self._sizes.clear()
        self._times.append(now)
        self._sizes.append(len(message))

    def figures(self) -> dict[str, float] | None:
        times, sizes = list(self._times), list(self._sizes)  # Zenoh's thread goes on adding
        if min(len(times), len(sizes)) < 2:
            return None
        elapsed = (self._now_ns() - times[0]) / 1e9
        if elapsed <= 0:  # simulated time stands still
            return None
        return {
            "bytes_per_second": sum(sizes) / elapsed,
            "messages": len(sizes),
            "mean": sum(sizes) / len(sizes),
            "min": min(sizes),
            "max": max(sizes),
        }


class Bandwidths:
    """How many bytes come: `zbot topic bw`."""

    announces = True
    decodes = reads_stamps = False
    columns: tuple[str, ...] = ("topic", "rate", "messages", "mean", "min", "max")

    def __init__(self, window: int) -> None:
        self._window = window

    def meter(self, now_ns: Callable[[], int]) -> Meter:
        """Return a meter for one topic."""
        return _SizeMeter(self._window, now_ns)

    def text(self, figures: dict[str, float]) -> str:
        """Return the two lines of ros2."""
        rate, mean, low, high = self._in_unit(figures)
        return (
            f"{rate}/s from {figures['messages']:.0f} messages\n"
            f"\tMessage size mean: {mean} min: {low} max: {high}"
        )

    def cells(self, figures: dict[str, float]) -> list[str]:
        """Return a row of the table, without the topic."""
        rate, *sizes = self._in_unit(figures)
        return [f"{rate}/s", f"{figures['messages']:.0f}", *sizes]

    @staticmethod
    def _in_unit(figures: dict[str, float]) -> list[str]:
        values = [figures[key] for key in ("bytes_per_second", "mean", "min", "max")]
        if values[0] < 1000:
            return [f"{value:.0f} B" for value in values]
        scale, unit = (1e3, "KB") if values[0] < 1e6 else (1e6, "MB")
        return [f"{value / scale:.2f} {unit}" for value in values]


class _DelayMeter:
    def __init__(self, window: int, now_ns: Callable[[], int]) -> None:
        self._delays: deque[float] = deque(maxlen=max(window, 1))
        self._now_ns = now_ns
        self._begun = self._news = False

    def add(self, message: Any) -> None:
        header = getattr(message, "header", None)
        if header is None:
            raise MissingHeaderError
        age_ns = self._now_ns() - (header.stamp.sec * 10**9 + header.stamp.nanosec)
        if self._begun:  # as in ROS 2, the first message is not counted
            self._delays.append(age_ns / 1e9)
            self._news = True
        self._begun = True

    def figures(self) -> dict[str, float] | None:
        if not self._news:
            return None
        self._news = False
        mean, low, high, deviation = spread(self._delays)
        return {
            "delay": mean,
            "min": low,
            "max": high,
            "std_dev": deviation,
            "window": len(self._delays),
        }


class Delays:
    """How old messages are when they come: `zbot topic delay`."""

    announces = False
    decodes = reads_stamps = True
    columns: tuple[str, ...] = ("topic", "delay", "min", "max", "std_dev", "window")

    def __init__(self, window: int) -> None:
        self._window = window

    def meter(self, now_ns: Callable[[], int]) -> Meter:
        """Return a meter for one topic."""
        return _DelayMeter(self._window, now_ns)

    def text(self, figures: dict[str, float]) -> str:
        """Return the two lines of ros2."""
        return (
            f"average delay: {figures['delay']:.3f}\n"
            f"\tmin: {figures['min']:.3f}s max: {figures['max']:.3f}s "
            f"std dev: {figures['std_dev']:.5f}s window: {figures['window']}"
        )

    def cells(self, figures: dict[str, float]) -> list[str]:
        """Return a row of the table, without the topic."""
        return [f"{figures[key]:.5f}" for key in ("delay", "min", "max", "std_dev")] + [
            f"{figures['window']}"
        ]


def measure(
    kind: Kind,
    topics: Sequence[str],
    choice: Choice,
    *,
    all_topics: bool,
    as_json: bool,
    use_sim_time: bool,
) -> None:
    """Measure topics until Ctrl-C.

    Raises:
        NoTopicError: No topic was named.
    """
    import zbot  # noqa: PLC0415 - makes the message packages importable

    with hidden_node("measure", use_sim_time=use_sim_time) as node:
        graph = node.context.graph.snapshot()
        names = [name for name, _ in graph.topics()] if all_topics else list(map(full_name, topics))
        if not names:
            raise NoTopicError
        now_ns = time.monotonic_ns
        if use_sim_time or kind.reads_stamps:
            now_ns = partial(_now_ns, node)
        meters = {name: kind.meter(now_ns) for name in names}
        for name, meter in meters.items():
            publishers = graph.publishers(name)
            if not as_json:
                _announce(kind, name, known=bool(publishers), several=len(names) > 1)
            if kind.decodes:
                _listen(node, name, meter, choice.to_subscribe(publishers))
            else:
                _count(node, name, meter)
        report = _Report(kind, meters, as_json=as_json)
        node.create_timer(_PERIOD_S, report.show)
        zbot.spin(node)


def _now_ns(node: Node) -> int:
    return node.get_clock().now().nanoseconds


def _announce(kind: Kind, name: str, *, known: bool, several: bool) -> None:
    if not known:
        print(f"WARNING: topic [{name}] does not appear to be published yet")
    if kind.announces or several:
        print(f"Subscribed to [{name}]")
    sys.stdout.flush()


def _listen(node: Node, name: str, meter: Meter, qos: QoSProfile) -> None:
    from zbot_cli.domain.topic_types import message_class, wait_for_type  # noqa: PLC0415 - few need types

    qos.depth = max(qos.depth, _DEPTH)
    node.create_subscription(message_class(wait_for_type(node, name)), name, meter.add, qos)


def _count(node: Node, name: str, meter: Meter) -> None:
    # Bytes need no type: this also measures the topics of plain Zenoh programs.
    context = node.context
    key = context.dialect.topic_key(context.get_domain_id(), name)
    context.session.declare_subscriber(key, lambda sample: meter.add(sample.payload))


class _Report:
    def __init__(self, kind: Kind, meters: dict[str, Meter], *, as_json: bool) -> None:
        self._kind = kind
        self._meters = meters
        self._as_json = as_json
        self._begun = False

    def show(self) -> None:
        found = {name: meter.figures() for name, meter in self._meters.items()}
        news = {name: figures for name, figures in found.items() if figures is not None}
        if self._as_json:
            for name, figures in news.items():
                print_json({"topic": name, **figures})
        elif len(self._meters) > 1:
            if news:
                print(self._table(news))
        elif news:
            print(self._kind.text(next(iter(news.values()))))
        elif self._begun:
            print(_NO_NEWS)
        self._begun = self._begun or bool(news)
        sys.stdout.flush()

    def _table(self, news: dict[str, dict[str, float]]) -> str:
        rows = [[name, *self._kind.cells(figures)] for name, figures in news.items()]
        columns = list(zip(self._kind.columns, *rows, strict=True))
        widths = [max(map(len, column)) for column in columns]
        head = "   ".join(
            name.center(width) for name, width in zip(self._kind.columns, widths, strict=True)
        )
        lines = [
            "   ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True))
            for row in rows
        ]
        return "\n".join((head.rstrip(), "=" * len(head), *lines, ""))
