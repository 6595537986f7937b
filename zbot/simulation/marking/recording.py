"""Recording of a run: a bag with the messages of the simulator and of the program.

The messages have the time of the world. Two equal runs give equal bags.
"""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING, Any

from zbot.bag.metadata import TopicMetadata
from zbot.bag.writer import Writer
from zbot.errors import ZbotError
from zbot.interfaces import get_message
from zbot.qos import QoSProfile, ReliabilityPolicy

if TYPE_CHECKING:
    from pathlib import Path

    from zbot.simulation.node.simulator import Simulator

#: Log lines have the real time. Images cost much time, and nobody needs them to mark a run.
_LEFT_OUT = frozenset({"/rosout", "/parameter_events", "/simulation/things", "/simulation/world"})
_LARGE = ("image_raw", "camera_info", "/points")
_QUEUE = 1000


class RunRecording:
    """Recording of one run.

    Args:
        simulator: The simulator, which must be in lockstep.
        path: The folder of the bag, which must not exist.

    Attributes:
        counts: The number of messages of each topic of the program.
    """

    def __init__(self, simulator: Simulator, path: Path) -> None:
        self._simulator, self._bag = simulator, Writer(path)
        self._subscriptions: dict[str, Any] = {}
        self._heard: list[tuple[str, bytes]] = []
        self.counts: Counter[str] = Counter()
        simulator.outbox.wants = self._wants
        simulator.outbox.note = self._write

    @staticmethod
    def _wants(topic: str) -> bool:
        return topic not in _LEFT_OUT and not topic.endswith(_LARGE)

    def _write(self, topic: str, message: Any) -> None:
        if topic not in _LEFT_OUT:
            self._bag.write(topic, message, self._simulator.world.time_ns)

    def follow_program(self) -> None:
        """Subscribe to the topics that other nodes publish."""
        own = self._simulator.handle.token.zid
        for token in self._simulator.context.graph.snapshot().endpoints:
            topic = token.name
            is_theirs = token.zid != own and token.kind.value == "MP"
            if is_theirs and topic not in self._subscriptions and topic not in _LEFT_OUT:
                self._subscribe(topic, token.type_name)

    def _subscribe(self, topic: str, type_name: str) -> None:
        self._subscriptions[topic] = None
        try:
            self._bag.create_topic(TopicMetadata(topic, type_name))
            type_ = get_message(type_name)
        except ZbotError:
            return  # a type that only the program knows
        self._subscriptions[topic] = self._simulator.create_subscription(
            *(type_, topic, lambda data: self._hear(topic, data)),
            QoSProfile(depth=_QUEUE, reliability=ReliabilityPolicy.BEST_EFFORT),
            raw=True,
        )

    def _hear(self, topic: str, data: bytes) -> None:
        self.counts[topic] += 1
        self._heard.append((topic, data))

    def end_instant(self) -> None:
        """Write what the program has sent in this instant, in an order that does not change."""
        for topic, data in sorted(self._heard, key=lambda heard: heard[0]):
            self._bag.write_serialized(topic, data, self._simulator.world.time_ns)
        self._heard.clear()

    def close(self) -> None:
        """Close the bag."""
        self._bag.close()
