"""Recorder of topics of the domain, as `ros2 bag record`."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from functools import partial
from typing import TYPE_CHECKING, Any

from zbot.bag.action_description import action_name
from zbot.bag.definition import ENCODING, definition_text
from zbot.bag.message import BagMessage, Definition
from zbot.bag.metadata import TopicMetadata
from zbot.bag.recorder_services import RecorderServices
from zbot.bag.write_queue import WriteQueue
from zbot.errors import ZbotError
from zbot.executor.clock import Clock
from zbot.executor.task import Future
from zbot.interfaces import has_sequences, type_hash
from zbot.names import is_hidden
from zbot.remote.profiles import profile_to_record
from zbot.remote.types import UnknownTypeError, interface
from zbot.time import ClockType

if TYPE_CHECKING:
    from collections.abc import Mapping

    from zbot.bag.selection import Selection
    from zbot.bag.snapshot_buffer import SnapshotBuffer
    from zbot.bag.writer import Writer
    from zbot.executor.executor import Executor
    from zbot.graph.snapshot import Snapshot
    from zbot.node.message_info import MessageInfo
    from zbot.node.node import Node
    from zbot.node.subscription import Subscription
    from zbot.qos import QoSProfile

MAX_CACHE_BYTES = 100 * 2**20  #: rosbag2's default
# Number of messages that can wait in Zenoh while this process is busy. A message with sequences may
# be large, so fewer such messages can wait.
_DEPTH = 2000
_DEPTH_OF_SEQUENCES = 500
_CHECK_S = 0.1
_REPORT_NS = 1_000_000_000


@dataclass(frozen=True)
class Discovery:
    """How a recorder finds topics."""

    is_on: bool = True  #: whether topics that appear later are recorded
    period_s: float = 0.1
    includes_hidden: bool = False
    includes_unpublished: bool = False
    ignores_leaves: bool = False  #: whether topics without a subscription are left out


@dataclass
class Losses:
    """Messages that were sent but not recorded, by topic."""

    counts: Counter[str] = field(default_factory=Counter)
    reported: int = 0

    def text(self) -> str:
        """Return the losses as text: `3 messages were lost: /a 2, /b 1`."""
        total = sum(self.counts.values())
        return f"{total} {'message was' if total == 1 else 'messages were'} lost: {self.list()}"

    def list(self) -> str:
        """Return the losses by topic: `/a 2, /b 1`. Without losses, the text is empty."""
        return ", ".join(f"{name} {count}" for name, count in sorted(self.counts.items()))


class Recorder:
    """Recorder of topics. The node's executor runs all callbacks of the recorder.

    Args:
        node: The node that subscribes.
        writer: The bag. The recorder closes it.
        selection: The topics.
        discovery: How topics are found.
        overrides: Profiles of the subscriptions to some topics.
        max_cache_bytes: Bytes of the messages that may wait for the disk. 0 means no limit.
        is_paused: Whether to begin paused.
        uses_sim_time: Whether the node's time is simulated. Messages that arrive before the first
            message of `/clock` are dropped.
        snapshots: Memory of the newest messages. Only `take_snapshot` writes them to the bag.
            `None` means that all messages are written to the bag.
    """

    def __init__(
        self,
        node: Node,
        writer: Writer,
        selection: Selection,
        *,
        discovery: Discovery,
        overrides: Mapping[str, QoSProfile],
        max_cache_bytes: int = MAX_CACHE_BYTES,
        is_paused: bool = False,
        uses_sim_time: bool = False,
        snapshots: SnapshotBuffer | None = None,
    ) -> None:
        self._node = node
        self._log = node.get_logger()
        self._queue = WriteQueue(writer, max_cache_bytes)
        self._selection = selection
        self._discovery = discovery
        self._overrides = overrides
        self._is_paused = is_paused
        self._uses_sim_time = uses_sim_time
        self._snapshots = snapshots
        self._subscriptions: dict[str, Subscription[Any]] = {}
        self._known: Snapshot | None = None
        self._warned: set[str] = set()
        self._losses = Losses()
        self._next_report_ns = 0
        self._clock = Clock(clock_type=ClockType.STEADY_TIME)
        self._done: Future[None] | None = None
        self._is_ended = False
        self._services = RecorderServices(node, self)
        writer.on_split = self._services.announce_split

    @property
    def is_paused(self) -> bool:
        """Whether messages are dropped at present."""
        return self._is_paused

    @property
    def takes_snapshots(self) -> bool:
        """Whether messages are written only by `take_snapshot`."""
        return self._snapshots is not None

    @property
    def losses(self) -> Losses:
        """Messages that were sent but not recorded."""
        return self._losses

    def toggle_paused(self) -> None:
        """Pause or resume. Messages that come during a pause are dropped. Any thread may call."""
        if self._is_paused:
            self.resume()
        else:
            self.pause()

    def pause(self) -> None:
        """Drop the messages that come from now on. Any thread may call."""
        if not self._is_paused:
            self._is_paused = True
            self._log.info("Pausing recording.")

    def resume(self) -> None:
        """End the pause. Any thread may call."""
        if self._is_paused:
            self._is_paused = False
            self._log.info("Resuming recording.")

    def split(self) -> None:
        """Begin the next file of the bag. Any thread may call."""
        self._queue.split()

    def take_snapshot(self) -> bool:
        """Write the messages in memory into a new file. Only the executor's thread may call.

        Returns:
            Whether the recorder is in snapshot mode.
        """
        if self._snapshots is None:
            return False
        messages = self._snapshots.take()
        self._queue.split()
        self._queue.put_all(messages)
        self._log.info(f"Snapshot of {len(messages)} messages")
        return True

    def end(self) -> None:
        """End `run`. Any thread may call, also before `run`."""
        self._is_ended = True
        if self._done is not None and not self._done.done():
            self._done.set_result(None)

    def run(self, executor: Executor) -> None:
        """Record until `end`, until the context ends, or until the bag cannot be written."""
        self._done = Future(executor=executor)
        if self._is_ended:
            self._done.set_result(None)
        self._node.context.graph.watch()
        self._log.info("Listening for topics...")
        self._discover()
        if self._is_paused:
            self._log.info("Wait for recording: Press SPACE to start.")
        else:
            self._log.info("Recording...")
        # The timers use a steady clock, because simulated time may stand still.
        finder = None
        if self._discovery.is_on:
            finder = self._node.create_timer(
                max(self._discovery.period_s, 0.001), self._rediscover, clock=self._clock
            )
        checker = self._node.create_timer(_CHECK_S, self._check, clock=self._clock)
        self._finder = finder
        executor.spin_until_future_complete(self._done)
        checker.cancel()

    def stop(self) -> None:
        """Write the waiting messages, close the bag, and report losses.

        Raises:
            BagWriteError: The bag cannot be written, e.g. because the disk is full. What was
                written before can be read.
        """
        for subscription in self._subscriptions.values():
            subscription.destroy()
        try:
            self._queue.close(self._losses.list())
        finally:
            self._log.info("Recording stopped")
            for name, subscription in self._subscriptions.items():
                if subscription.refused_count:
                    count = subscription.refused_count
                    self._log.error(f"{name}: {count} messages could not be read")
            if self._losses.counts:
                self._log.warning(self._losses.text())

    def _check(self) -> None:
        if self._queue.error is not None:
            self.end()
        now_ns = self._clock.now().nanoseconds
        total = sum(self._losses.counts.values())
        if total > self._losses.reported and now_ns >= self._next_report_ns:
            self._losses.reported = total
            self._next_report_ns = now_ns + _REPORT_NS
            self._log.warning(f"{self._losses.text()} (so far)")

    def _rediscover(self) -> None:
        self._discover()
        if (
            self._finder is not None
            and self._selection.is_list
            and self._selection.names <= set(self._subscriptions)
        ):
            self._finder.cancel()
            self._finder = None
            self._log.info("All requested topics are subscribed. Stopping discovery...")

    def _discover(self) -> None:
        snapshot = self._node.context.graph.snapshot()
        if snapshot is self._known:
            return
        self._known = snapshot
        for topic, types in snapshot.topics():
            if topic not in self._subscriptions and self._is_wanted(snapshot, topic, types):
                self._subscribe(snapshot, topic, types[0])

    def _is_wanted(self, snapshot: Snapshot, topic: str, types: list[str]) -> bool:
        if not any(self._selection.takes(topic, one) for one in types):
            return False
        if len(types) > 1:
            self._warn(
                topic,
                f"Topic '{topic}' has more than one type associated. Only topics with one type "
                f"are supported: {', '.join(types)}",
            )
            return False
        if self._is_left_out(topic):
            self._warn(
                "", "Hidden topics are not recorded. Enable them with --include-hidden-topics"
            )
            return False
        others = [one for one in snapshot.publishers(topic) if not self._is_own(one)]
        if not others and not self._discovery.includes_unpublished:
            return False
        listeners = [one for one in snapshot.subscriptions(topic) if not self._is_own(one)]
        return bool(listeners) or not self._discovery.ignores_leaves

    def _is_left_out(self, topic: str) -> bool:
        is_wanted = self._discovery.includes_hidden or topic in self._selection.names
        is_selected = topic.endswith("/_service_event") or action_name(topic)
        return is_hidden(topic) and not is_wanted and not is_selected

    def _is_own(self, end: Any) -> bool:
        return bool(end.zid == self._node.context.zid)

    def _subscribe(self, snapshot: Snapshot, topic: str, type_name: str) -> None:
        message_class = self._class(topic, type_name)
        if message_class is None:
            return
        offered = [one.qos for one in snapshot.publishers(topic)]
        depth = _DEPTH_OF_SEQUENCES if has_sequences(message_class) else _DEPTH
        profile = self._overrides.get(topic)
        if profile is None:
            profile = profile_to_record(offered, depth)
        else:
            self._log.info(f"Overriding subscription profile for {topic}")
        self._queue.add_topic(
            TopicMetadata(
                topic,
                type_name,
                offered_qos_profiles=tuple(offered),
                type_hash=type_hash(type_name),
            ),
            Definition(ENCODING, definition_text(type_name)),
        )
        subscription = self._node.create_subscription(
            message_class, topic, partial(self._record, topic), profile, raw=True
        )
        subscription.report_losses_to(partial(self._count_loss, topic))
        self._subscriptions[topic] = subscription
        self._log.info(f"Subscribed to topic '{topic}'")

    def _class(self, topic: str, type_name: str) -> type[Any] | None:
        """Return the class of a topic's type. Ask other nodes if the type is not known here."""
        try:
            return interface(self._node.context, type_name)
        except UnknownTypeError:
            reason = "neither this machine nor a node has its definition"
        except ZbotError as error:
            reason = str(error)
        self._warn(
            topic,
            f"Topic '{topic}' has unknown type '{type_name}' . "
            f"Only topics with known type are supported. Reason: '{reason}'",
        )
        return None

    def _record(self, topic: str, data: bytes, info: MessageInfo) -> None:
        if self._is_paused:
            return
        log_ns = info["received_timestamp"]
        if self._uses_sim_time:
            log_ns = self._node.get_clock().now().nanoseconds
            if log_ns == 0:
                return  # no message of /clock has come
        sent_ns = info["source_timestamp"] or log_ns
        message = BagMessage(topic, data, log_ns, sent_ns)
        if self._snapshots is not None:
            self._snapshots.add(message)
        elif not self._queue.put(message):
            self._losses.counts[topic] += 1

    def _count_loss(self, topic: str, count: int) -> None:
        if not self._is_paused:
            self._losses.counts[topic] += count

    def _warn(self, subject: str, text: str) -> None:
        if subject not in self._warned:
            self._warned.add(subject)
            self._log.warning(text)
