"""Recorder of topics of the domain, as `ros2 bag record`."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from functools import partial
from typing import TYPE_CHECKING, Any

from zbot.bag.definition import ENCODING, definition_text
from zbot.bag.description import action_name
from zbot.bag.message import BagMessage, Definition
from zbot.bag.metadata import TopicMetadata
from zbot.bag.write_queue import SnapshotBuffer, WriteQueue
from zbot.bag.writer import writer_for
from zbot.errors import ZbotError, counted
from zbot.executor.clock import Clock
from zbot.executor.task import Future
from zbot.graph.snapshot import Snapshot
from zbot.interfaces import get_interface, has_sequences, type_hash
from zbot.names import is_hidden
from zbot.remote.profiles import profile_to_record
from zbot.remote.types import TypeSearch, UnknownTypeError
from zbot.time import ClockType

if TYPE_CHECKING:
    from pathlib import Path

    from zbot.bag.options import RecordOptions, StorageOptions
    from zbot.executor.executor import Executor
    from zbot.node.message_info import MessageInfo
    from zbot.node.node import Node
    from zbot.node.subscription import Subscription

# Number of messages that can wait in Zenoh while this process is busy. A message with sequences may
# be large, so fewer such messages can wait.
_DEPTH = 2000
_DEPTH_OF_SEQUENCES = 500
_CHECK_S = 0.1
_REPORT_NS = 1_000_000_000


@dataclass
class Losses:
    """Messages that were sent but not recorded, by topic."""

    counts: Counter[str] = field(default_factory=Counter)
    reported: int = 0

    def text(self) -> str:
        """Return the losses as text: `3 messages were lost: /a 2, /b 1`."""
        total = sum(self.counts.values())
        return f"{counted(total, 'message')} {'was' if total == 1 else 'were'} lost: {self.list()}"

    def list(self) -> str:
        """Return the losses by topic: `/a 2, /b 1`. Without losses, the text is empty."""
        return ", ".join(f"{name} {count}" for name, count in sorted(self.counts.items()))


class Recorder:
    """Recorder of topics. The node's executor runs all callbacks of the recorder.

    Args:
        node: The node that subscribes.
        storage: The new bag.
        options: What to record. If the time is simulated, messages that arrive before the first
            message of `/clock` are dropped. In snapshot mode, the newest messages stay in memory,
            and only `take_snapshot` writes them to the bag.

    Raises:
        BagExistsError: The bag exists.
        BagWriteError: The bag cannot be made.
        BagValueError: The storage's settings are not valid.
    """

    def __init__(self, node: Node, storage: StorageOptions, options: RecordOptions) -> None:
        self._selection = options.selection()
        writer = writer_for(storage, options)
        self._node = node
        self._log = node.get_logger()
        self._queue = WriteQueue(writer, storage.max_cache_size)
        self._options = options
        self._is_paused = options.start_paused
        self._snapshots = (
            SnapshotBuffer(storage.max_cache_size, storage.max_cache_duration)
            if storage.snapshot_mode
            else None
        )
        self._subscriptions: dict[str, Subscription[Any]] = {}
        self._known = Snapshot(())
        node.context.graph.watch()
        self._types = TypeSearch(node.context)
        self._searched_types: set[str] = set()  # those that a thread searches at present
        self._type_searched = node.create_guard_condition(self._subscribe_to_new)
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
        self._log.info(f"Snapshot of {counted(len(messages), 'message')}")
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
        self._log.info("Listening for topics...")
        self._discover()
        if self._is_paused:
            self._log.info("Wait for recording: Press SPACE to start.")
        else:
            self._log.info("Recording...")
        # The timers use a steady clock, because simulated time may stand still.
        finder = None
        if not self._options.is_discovery_disabled:
            finder = self._node.create_timer(
                max(self._options.topic_polling_interval.total_seconds(), 0.001),
                self._rediscover,
                clock=self._clock,
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
                    count = counted(subscription.refused_count, "message")
                    self._log.error(f"{name}: {count} could not be read")
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
        if snapshot is not self._known:
            self._known = snapshot
            self._subscribe_to_new()

    def _subscribe_to_new(self) -> None:
        """Subscribe to the wanted topics of the known graph that have no subscription yet."""
        snapshot = self._known
        for topic, types in snapshot.topics():
            if topic not in self._subscriptions and self._is_wanted(snapshot, topic, types):
                self._subscribe(snapshot, topic, types[0])

    def _is_wanted(self, snapshot: Snapshot, topic: str, types: list[str]) -> bool:
        if not any(self._selection.takes(topic, type_name) for type_name in types):
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
        others = [
            publisher for publisher in snapshot.publishers(topic) if not self._is_own(publisher)
        ]
        if not others and not self._options.include_unpublished_topics:
            return False
        listeners = [
            subscription
            for subscription in snapshot.subscriptions(topic)
            if not self._is_own(subscription)
        ]
        return bool(listeners) or not self._options.ignore_leaf_topics

    def _is_left_out(self, topic: str) -> bool:
        is_wanted = self._options.include_hidden_topics or topic in self._selection.names
        is_selected = topic.endswith("/_service_event") or action_name(topic)
        return is_hidden(topic) and not is_wanted and not is_selected

    def _is_own(self, end: Any) -> bool:
        return bool(end.zid == self._node.context.zid)

    def _subscribe(self, snapshot: Snapshot, topic: str, type_name: str) -> None:
        message_class = self._class(topic, type_name)
        if message_class is None:
            return
        offered = [publisher.qos for publisher in snapshot.publishers(topic)]
        depth = _DEPTH_OF_SEQUENCES if has_sequences(message_class) else _DEPTH
        profile = self._options.topic_qos_profile_overrides.get(topic)
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
        """Return the class of a topic's type, or `None` if it is not known here, at least not yet.

        Then a thread asks other nodes, because they may answer late.
        """
        failure = self._types.failure(type_name)
        if failure is None:
            try:
                return get_interface(type_name)
            except ZbotError:
                self._search(type_name)
                return None
        reason = str(failure)
        if isinstance(failure, UnknownTypeError):
            reason = "neither this machine nor a node has its definition"
        self._warn(
            topic,
            f"Topic '{topic}' has unknown type '{type_name}' . "
            f"Only topics with known type are supported. Reason: '{reason}'",
        )
        return None

    def _search(self, type_name: str) -> None:
        def search() -> None:
            try:
                self._types.search(type_name)
            finally:
                self._searched_types.discard(type_name)
                self._type_searched.trigger()

        if type_name not in self._searched_types:
            self._searched_types.add(type_name)
            self._node.context.start_thread(f"zbot type {type_name}", search)

    def _record(self, topic: str, data: bytes, info: MessageInfo) -> None:
        if self._is_paused:
            return
        log_ns = info["received_timestamp"]
        if self._options.use_sim_time:
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


class RecorderServices:
    """Services `~/pause`, `~/resume`, `~/is_paused`, `~/split_bagfile` and `~/snapshot`.

    The node also publishes on `events/write_split` when a file of the bag is complete.

    Args:
        node: The recorder's node. Its executor runs the services.
        recorder: The recorder.
    """

    def __init__(self, node: Node, recorder: Recorder) -> None:
        from rosbag2_interfaces import msg, srv  # noqa: PLC0415 - the import makes the classes

        self._name = node.get_fully_qualified_name()
        self._recorder = recorder
        self._event_class: Any = msg.WriteSplitEvent
        self._splits = node.create_publisher(self._event_class, "events/write_split", 1)
        node.create_service(srv.Pause, "~/pause", self._pause)
        node.create_service(srv.Resume, "~/resume", self._resume)
        node.create_service(srv.IsPaused, "~/is_paused", self._is_paused)
        node.create_service(srv.SplitBagfile, "~/split_bagfile", self._split)
        if recorder.takes_snapshots:
            node.create_service(srv.Snapshot, "~/snapshot", self._snapshot)

    def announce_split(self, closed: Path, opened: Path) -> None:
        """Publish that a file is complete."""
        self._splits.publish(
            self._event_class(
                closed_file=str(closed), opened_file=str(opened), node_name=self._name
            )
        )

    def _pause(self, request: Any, response: Any) -> Any:  # noqa: ARG002 - rclpy's signature
        self._recorder.pause()
        return response

    def _resume(self, request: Any, response: Any) -> Any:  # noqa: ARG002 - as above
        self._recorder.resume()
        return response

    def _is_paused(self, request: Any, response: Any) -> Any:  # noqa: ARG002 - as above
        response.paused = self._recorder.is_paused
        return response

    def _split(self, request: Any, response: Any) -> Any:  # noqa: ARG002 - as above
        self._recorder.split()
        return response

    def _snapshot(self, request: Any, response: Any) -> Any:  # noqa: ARG002 - as above
        response.success = self._recorder.take_snapshot()
        return response
