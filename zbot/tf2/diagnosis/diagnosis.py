"""Diagnosis of all transforms that were heard."""

from __future__ import annotations

import threading
import time
from typing import TYPE_CHECKING, Any

from zbot.tf2.broadcaster import TF_TOPIC
from zbot.tf2.diagnosis import time_problems, topic_problems, tree_problems
from zbot.tf2.diagnosis.forest import Forest
from zbot.tf2.diagnosis.link import Link
from zbot.tf2.diagnosis.missing import MissingTransform
from zbot.tf2.diagnosis.surroundings import CLOCK_TOPIC, Surroundings
from zbot.tf2.diagnosis.time_problems import Need

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from zbot.tf2.diagnosis.forest import Branch
    from zbot.tf2.diagnosis.problem import Problem

_STATIC = "_static"
_MOST_LINKS = 10_000  # a program may give each transform another name


class Diagnosis:
    """Record of the transforms that were heard. It says what is wrong, and why one is missing.

    All methods may be called from any thread. Times are nanoseconds since the epoch.

    Args:
        topic: The topic of moving transforms that the program hears. Its static twin is
            `TOPIC_static`. Transforms of other topics are known, but do not count as heard.
    """

    def __init__(self, topic: str = TF_TOPIC) -> None:
        self.topic = topic
        self._links: dict[tuple[str, str, str], Link] = {}
        self._publishers: Mapping[str, Sequence[str]] = {}
        self._listeners: Mapping[str, Sequence[str]] = {}
        self._lock = threading.RLock()

    def add_message(
        self,
        message: Any,
        topic: str = TF_TOPIC,
        *,
        received_ns: int | None = None,
        sent_ns: int = 0,
        publisher: str = "",
    ) -> None:
        """Take a `TFMessage`.

        Args:
            message: The message.
            topic: Its topic. Transforms are static if the name ends with `tf_static`.
            received_ns: The time of its arrival. The default is now.
            sent_ns: The time at which it was sent, by the publisher's clock, or 0 if unknown.
            publisher: The full name of the node that sent it, or nothing if unknown.
        """
        now_ns = time.time_ns() if received_ns is None else received_ns
        with self._lock:
            for transform in message.transforms:
                parent, child = transform.header.frame_id, transform.child_frame_id
                link = self._links.get((topic, parent, child)) or self._new(topic, parent, child)
                link.add(transform, received_ns=now_ns, sent_ns=sent_ns, publisher=publisher)

    def _new(self, topic: str, parent: str, child: str) -> Link:
        """Return the link of two names. A leading slash does not make another link."""
        if len(self._links) >= _MOST_LINKS:
            self._links.clear()
        bare = parent.removeprefix("/"), child.removeprefix("/")
        link = self._links.setdefault((topic, *bare), Link(*bare, topic))
        link.has_slash = link.has_slash or bare != (parent, child)
        return self._links.setdefault((topic, parent, child), link)

    def set_endpoints(
        self, publishers: Mapping[str, Sequence[str]], listeners: Mapping[str, Sequence[str]]
    ) -> None:
        """Say which nodes publish and hear transforms and `/clock`, by topic."""
        with self._lock:
            self._publishers, self._listeners = publishers, listeners

    def clear(self) -> None:
        """Forget all transforms except static ones, which are published only once."""
        with self._lock:
            self._links = {key: link for key, link in self._links.items() if link.is_static}

    @property
    def topics(self) -> list[str]:
        """The topics of moving transforms. The one that the program hears is the first."""
        with self._lock:
            heard = {link.topic.removesuffix(_STATIC) for link in self._links.values()}
            known = {topic.removesuffix(_STATIC) for topic in self._publishers}
        return [self.topic, *sorted((heard | known) - {self.topic, CLOCK_TOPIC})]

    def links(self, topic: str | None = None) -> list[Link]:
        """Return what was heard on a topic and its static twin, sorted by child and parent."""
        wanted = self.topic if topic is None else topic
        with self._lock:
            found = {id(link): link for link in self._links.values()}.values()
        own = [link for link in found if link.topic.removesuffix(_STATIC) == wanted]
        return sorted(own, key=lambda link: (link.child, link.parent))

    def forest(self, topic: str | None = None) -> Forest:
        """Return the trees of frames of a topic and its static twin."""
        with self._lock:
            links = self.links(topic)
            surroundings = self._surroundings(self.topic, 0)
            return Forest(links, [link for link in links if surroundings.has_ended(link)])

    def branches(self, topic: str | None = None) -> list[Branch]:
        """Return the lines of a drawing of a topic's trees, with the links that are missing."""
        with self._lock:
            forest = self.forest(topic)
            return list(forest.branches(tree_problems.missing_links(forest)))

    def problems(self, *, now_ns: int | None = None) -> list[Problem]:
        """Return all problems. Problems that make transforms impossible come before warnings."""
        found: list[Problem] = []
        with self._lock:
            heard = self.forest()
            for topic in self.topics:
                forest, surroundings = self.forest(topic), self._surroundings(topic, now_ns)
                found += tree_problems.of_forest(forest, surroundings)
                found += time_problems.of_links(forest.links, surroundings)
                found += topic_problems.of_topic(forest, heard, surroundings)
            if not self._links:
                found += topic_problems.of_silence(self._surroundings(self.topic, now_ns))
        return sorted(found, key=lambda problem: problem.is_warning)

    def why(
        self,
        target: str,
        source: str,
        stamp_ns: int = 0,
        *,
        what: str = "the message",
        message_topic: str = "",
        now_ns: int | None = None,
    ) -> Problem | None:
        """Return why a transform is missing, or None if it is known.

        The problem is a warning if the transform is known, but is not reliable.

        Args:
            target: The frame of the coordinates, e.g. the fixed frame of a view.
            source: The frame whose position is wanted, e.g. the `frame_id` of a message.
            stamp_ns: The time of the transform. 0 means the latest.
            what: What needs the transform, e.g. `the newest scan`.
            message_topic: The topic of that message. The advice contains it.
            now_ns: The time of day. The default is now.
        """
        need = Need(stamp_ns, what, message_topic)
        with self._lock:
            others = {name: self.forest(name) for name in self.topics[1:]}
            surroundings = self._surroundings(self.topic, now_ns)
            search = MissingTransform(self.forest(), others, surroundings, need)
            found = search.reason(target, source)
        return None if found is None else found.for_transform(target, source)

    def _surroundings(self, topic: str, now_ns: int | None) -> Surroundings:
        now = time.time_ns() if now_ns is None else now_ns
        return Surroundings(now, topic, self._publishers, self._listeners)
