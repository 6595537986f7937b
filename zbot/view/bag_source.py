"""Bag that a view shows without a domain: its topics, its transforms and its time."""

from __future__ import annotations

import time
from functools import partial
from typing import TYPE_CHECKING, Any

from zbot.bag.errors import BagError
from zbot.observer.errors import ViewerError
from zbot.observer.watch import Feed, Watch
from zbot.qos import DurabilityPolicy
from zbot.tf2.broadcaster import TF_STATIC_TOPIC, TF_TOPIC
from zbot.threads.deadline import Deadline
from zbot.view.displays import display_for
from zbot.wire.errors import CodecError
from zbot.wire.serialization import deserialize_message

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from typing_extensions import Self

    from zbot.bag.message import BagMessage
    from zbot.bag.metadata import TopicMetadata
    from zbot.bag.reader import Reader
    from zbot.view.frames import Frames
    from zbot.view.source import Graph

_TRANSFORMS = (TF_TOPIC, TF_STATIC_TOPIC)
#: After a jump, messages of this time before it show what was there.
_BEFORE_NS = 10**9
_MOST_WORK_S = 0.1  #: a view is drawn again after this time, also if reading is slow


class BagSource:
    """Source, clock and timeline of a view that shows a bag. Only one thread may use it.

    Args:
        bag: The bag.
        frames: The transforms of the bag.

    Attributes:
        length_s: The length of the bag.
        problem: Why the bag cannot be read to its end, or an empty text.
    """

    def __init__(self, bag: Reader, frames: Frames) -> None:
        self.revision = 0
        self.problem = bag.damage
        self.length_s = bag.metadata.duration_ns / 1e9
        self._bag, self._frames = bag, frames
        self._frames.now_ns = self.now_ns
        self._topics = {_full(name): topic for name, topic in bag.topics.items()}
        self._types = {name: _type(bag, topic) for name, topic in self._topics.items()}
        self._feeds: dict[str, Feed] = {}
        self._holds: list[Watch] = []
        self._messages: Iterator[BagMessage] = iter(())
        self._next: BagMessage | None = None
        self._start_ns = self._position_ns = bag.metadata.start_ns
        self._speed = 1.0
        self._is_playing, self._has_jumped = True, False
        self._last_s = time.monotonic()
        self.seek(0.0)

    # -- what a view asks a source ---------------------------------------------------------------

    def snapshot(self) -> Graph:
        """Return the topics of the bag, which never change."""
        return self

    def topics(self) -> list[tuple[str, list[str]]]:
        """Return all topics with their types."""
        return [(name, [topic.type_name]) for name, topic in self._topics.items()]

    def publishers(self, topic: str) -> list[Any]:  # noqa: ARG002 - a source has it
        """Return nothing: nobody publishes."""
        return []

    def watch(self, topic: str, type_name: str | None = None, *, keep: int = 0) -> Watch:  # noqa: ARG002 - a source has it
        """Return a watch of a topic."""
        if topic not in self._feeds:
            self._feeds[topic] = self._feed(topic)
        return Watch(self._feeds[topic], keep=keep, is_active=True, forget=_ignore)

    # -- what a view asks a clock ----------------------------------------------------------------

    def look(self, graph: Graph) -> None:
        """Do nothing: the time is that of the bag."""

    def now_ns(self) -> int:
        """Return the time in the bag."""
        return int(self._position_ns)

    def has_jumped_back(self) -> bool:
        """Return whether there was a jump since the last call."""
        found, self._has_jumped = self._has_jumped, False
        return found

    # -- the timeline ----------------------------------------------------------------------------

    @property
    def position_s(self) -> float:
        """The time since the start of the bag."""
        return (self._position_ns - self._start_ns) / 1e9

    @property
    def is_playing(self) -> bool:
        """Whether the bag is played now."""
        return self._is_playing

    def play(self, is_playing: bool) -> None:
        """Play, or stand still. At the end, play again from the start."""
        if is_playing and not self._is_playing and self.position_s >= self.length_s:
            self.seek(0.0)
        self._is_playing = is_playing

    def set_speed(self, speed: float) -> None:
        """Play faster or slower."""
        self._speed = speed

    def seek(self, position_s: float) -> None:
        """Go to a time, and show what was there: latched messages, and the second before."""
        position_s = min(max(position_s, 0.0), self.length_s)
        self._position_ns = self._start_ns + round(position_s * 1e9)
        self._frames.clear()
        self._frames.diagnosis.clear()
        for hold in self._holds:
            hold.release()
        self._feeds, self._holds = {}, []
        for name, topic in self._topics.items():
            kind = display_for(name, topic.type_name)
            if kind is not None:
                self._holds.append(self.watch(name, keep=kind.kept))
        before_ns = max(self._position_ns - _BEFORE_NS, 0)
        latched = [topic.name for topic in self._topics.values() if _is_latched(topic)]
        if latched and before_ns > self._start_ns:
            self._take_all(self._bag.messages(latched, 0, before_ns - 1))
        self._messages = self._bag.messages(None, before_ns)
        self._next = self._read()
        self._take_until_now(Deadline(None))
        self._has_jumped = True

    def advance(self) -> None:
        """Take the messages up to the present time."""
        now_s = time.monotonic()
        past_s, self._last_s = now_s - self._last_s, now_s
        if not self._is_playing:
            return
        end_ns = self._start_ns + round(self.length_s * 1e9)
        self._position_ns = min(self._position_ns + round(past_s * self._speed * 1e9), end_ns)
        self._take_until_now(Deadline(_MOST_WORK_S))
        if self._position_ns >= end_ns:
            self._is_playing = False

    def _take_until_now(self, turn: Deadline) -> None:
        while self._next is not None and self._next.log_ns <= self._position_ns:
            if turn.is_over:
                self._position_ns = self._next.log_ns
                return
            self._take(self._next)
            self._next = self._read()

    def _read(self) -> BagMessage | None:
        try:
            return next(self._messages, None)
        except BagError as error:
            self.problem = str(error)
            return None

    def _take_all(self, messages: Iterator[BagMessage]) -> None:
        try:
            for message in messages:
                self._take(message)
        except BagError as error:
            self.problem = str(error)

    def _take(self, message: BagMessage) -> None:
        name = _full(message.topic)
        if name in _TRANSFORMS:
            self._add_transforms(name, message)
            return
        feed = self._feeds.get(name)
        if feed is not None:
            times: Any = {
                "source_timestamp": message.publish_ns,
                "received_timestamp": message.log_ns,
            }
            feed.take(message.data, times)

    def _add_transforms(self, name: str, message: BagMessage) -> None:
        cls = self._types[name]
        if isinstance(cls, str):
            self.problem = cls
            return
        try:
            found: Any = deserialize_message(message.data, cls)
        except CodecError as error:
            self.problem = f"a message of {name} cannot be decoded: {error}"
            return
        is_static = name == TF_STATIC_TOPIC
        add = self._frames.set_transform_static if is_static else self._frames.set_transform
        for transform in found.transforms:
            add(transform, "bag")
        self._frames.diagnosis.add_message(found, name, received_ns=message.log_ns)

    def _feed(self, topic: str) -> Feed:
        known = self._topics.get(topic)
        type_name = None if known is None else known.type_name
        feed = Feed(topic, type_name, _ignore, _ignore)
        cls = self._types.get(topic)
        if isinstance(cls, str):
            feed.problem = cls
        elif cls is not None:
            feed.decode = partial(_decoded, cls)
        return feed

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._bag.close()


class NoOutlet:
    """Outlet of the tools of a view that shows a bag."""

    def open(self, topic: str, type_name: str) -> None:
        """Refuse: there is no domain.

        Raises:
            ViewerError: Always.
        """
        raise ViewerError(f"a bag is shown: there is no domain for {topic} ({type_name})")

    def send(self, topic: str, type_name: str, message: Any) -> int:  # noqa: ARG002 - an outlet has it
        """Refuse, as `open`."""
        self.open(topic, type_name)
        return 0

    def navigate(self, pose: Any, topic: str) -> list[str]:  # noqa: ARG002 - an outlet has it
        """Send nothing."""
        return []

    def ask(
        self, service: str, type_name: str, request: Any, answer: Callable[[Any], object]
    ) -> None:
        """Ask nobody: there is no domain."""


def _full(name: str) -> str:
    """Return a name with a slash, which some programs leave out in bags."""
    return f"/{name.removeprefix('/')}"


def _type(bag: Reader, topic: TopicMetadata) -> type[Any] | str:
    """Return the class of a topic's messages, or why there is none."""
    try:
        return bag.message_class(topic)
    except BagError as error:
        return str(error)


def _is_latched(topic: TopicMetadata) -> bool:
    profiles = topic.offered_qos_profiles
    is_latched = any(one.durability is DurabilityPolicy.TRANSIENT_LOCAL for one in profiles)
    return is_latched or _full(topic.name) == TF_STATIC_TOPIC


def _decoded(cls: type[Any], data: bytes) -> Any:
    return deserialize_message(data, cls)


def _ignore(_: object) -> None:
    """Do nothing: a bag needs no subscriptions."""
