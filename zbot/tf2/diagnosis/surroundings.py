"""Surroundings of the frames: the time, and which nodes publish and listen."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from zbot.tf2.diagnosis.link import Link

CLOCK_TOPIC = "/clock"


@dataclass(frozen=True)
class Surroundings:
    """The time, and the nodes on the topics."""

    now_ns: int  #: nanoseconds since the epoch
    topic: str = "/tf"  #: topic of the transforms that the program hears
    publishers: Mapping[str, Sequence[str]] = field(default_factory=dict)  #: nodes by topic
    listeners: Mapping[str, Sequence[str]] = field(default_factory=dict)  #: nodes by topic

    @property
    def topics(self) -> tuple[str, str]:
        """The topic of moving transforms and that of static ones."""
        return self.topic, f"{self.topic}_static"

    @property
    def has_clock(self) -> bool:
        """Whether a node publishes simulated time."""
        return bool(self.publishers.get(CLOCK_TOPIC))

    @property
    def all_listeners(self) -> set[str]:
        """The nodes that hear the topics."""
        return {name for topic in self.topics for name in self.listeners.get(topic, ())}

    def silent_nodes(self, links: Iterable[Link]) -> list[str]:
        """Return the nodes that have a publisher for transforms, but published none of `links`."""
        heard = {name for link in links for name in link.publishers}
        able = {name for topic in self.topics for name in self.publishers.get(topic, ())}
        return sorted(able - heard)

    def has_ended(self, link: Link) -> bool:
        """Return whether the known publishers of a link have ended."""
        return bool(link.nodes) and not self.running_nodes(link)

    def running_nodes(self, link: Link) -> list[str]:
        """Return the nodes that publish a link and have not ended."""
        return [name for name in link.nodes if name in self.publishers.get(link.topic, ())]
