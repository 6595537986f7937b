"""Player of bags, as `ros2 bag play`. It publishes messages at the recorded intervals."""

from __future__ import annotations

import enum
import math
import sys
import threading
import time
from collections import deque
from typing import TYPE_CHECKING, Any

from zbot.bag.options import MessageOrder
from zbot.bag.playback_clock import PlaybackClock
from zbot.bag.player_topics import CLOCK_TOPIC, PlayedTopic, played_topics
from zbot.bag.qos_profiles import profile_to_publish
from zbot.bag.read_ahead import ReadAhead, in_send_order
from zbot.bag.reader import merge
from zbot.errors import NotInitializedError, ZbotError, counted
from zbot.memory import LARGE_BYTES
from zbot.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from zbot.threads.deadline import Deadline
from zbot.threads.wakeup import BinarySemaphore
from zbot.time import S_TO_NS, Time
from zbot.transport.admin_query import answers

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from zbot.bag.message import BagMessage
    from zbot.bag.options import PlayOptions
    from zbot.bag.reader import Reader
    from zbot.node.node import Node
    from zbot.node.publisher import Publisher

_CLOCK_QOS = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
_RATE_STEP = 0.1
# The last part of a wait, which is a busy wait. Windows and macOS wake a thread at most 1 ms late.
# Linux wakes a thread only 0.1 ms late, and a busy wait would need 10 % more of a processor.
_BUSY_S = 0.0 if sys.platform == "linux" else 0.0008
_LONGEST_WAIT_S = 0.5
_FILL_S = 2.0  #: longest time to read in advance before the first message
_FOREVER_S = 365 * 86400.0


class PlayerStatus(enum.Enum):
    """What a player does. The values are the letters of rosbag2's progress bar."""

    RUNNING = "R"
    PAUSED = "P"
    BURST = "B"
    DELAYED = "D"
    STOPPED = "S"


class Player:
    """Player of one bag or of several bags at the same time.

    `run` works in the calling thread. Any thread may call the other methods.

    Args:
        node: The node that publishes.
        bags: The bags.
        options: How to play.
    """

    def __init__(self, node: Node, bags: Sequence[Reader], options: PlayOptions) -> None:
        self._node = node
        self._log = node.get_logger()
        self._bags = bags
        self._options = options
        self._topics_with_clock = options.topics_with_clock
        filled = [bag.metadata for bag in bags if bag.metadata.message_count]
        self.bag_start_ns = min((bag.start_ns for bag in filled), default=0)
        self.bag_end_ns = max((bag.end_ns for bag in filled), default=0)
        self._start_ns = self.bag_start_ns + int(options.start_offset * S_TO_NS)
        self._is_paused = options.start_paused
        self._has_begun = False
        # The clock stands still until the first messages are read.
        self._clock = PlaybackClock(self._start_ns, options.rate, is_paused=True)
        self._changed = BinarySemaphore()
        node.context.add_waker(self._changed.set)
        self._lock = threading.Condition()
        self._steps: float = 0  # number of messages to publish while the player is paused
        self._seek_ns: int | None = None
        self._shows_state = False
        self._is_stopped = False
        self._is_over = threading.Event()
        self._is_delayed = False
        self.sent_count = 0  #: messages that were published
        self._topics = played_topics(node, bags, options)
        self._clock_publisher = self._create_clock()

    @property
    def is_paused(self) -> bool:
        """Whether the player waits for `resume` or `play_next`."""
        return self._is_paused

    @property
    def rate(self) -> float:
        """Seconds of the recording that pass in one second."""
        return self._clock.rate

    @property
    def position_ns(self) -> int:
        """Present time of the recording, in nanoseconds since the epoch."""
        return min(self._clock.now_ns(), max(self.bag_end_ns, self._start_ns))

    @property
    def status(self) -> PlayerStatus:
        """What the player does at present."""
        if self._is_over.is_set() or self._is_stopped:
            return PlayerStatus.STOPPED
        if self._is_delayed:
            return PlayerStatus.DELAYED
        if self._steps:
            return PlayerStatus.BURST
        return PlayerStatus.PAUSED if self._is_paused else PlayerStatus.RUNNING

    def run(self) -> None:
        """Play until the end, until `stop`, or until the context ends.

        Raises:
            BagReadError: A part of a bag is damaged.
        """
        self._log.info(f"Set rate to {self._options.rate:g}")
        end_ns = self._end_ns()
        self._log.info(f"Playback until timestamp: {-1 if end_ns is None else end_ns}")
        self._node.context.wait_for_peers()
        ticker = None
        if self._options.clock_publish_frequency > 0:
            ticker = threading.Thread(target=self._tick, name="zbot clock", daemon=True)
            ticker.start()
        try:
            is_first, before = True, -1
            # The loop ends after a round without messages, because such rounds never wait.
            while is_first or (self._options.loop and self.sent_count > before and self._is_ok()):
                before = self.sent_count
                self._play_once(is_first=is_first)
                is_first = False
            self._wait_for_subscribers()
        finally:
            self._is_over.set()
            with self._lock:
                self._steps = 0
                self._lock.notify_all()
            if ticker is not None:
                ticker.join()
            for name, topic in self._topics.items():
                if topic.errors:
                    self._log.error(f"{name}: {counted(topic.errors, 'message')} could not be read")

    def stop(self) -> None:
        """End `run`."""
        self._is_stopped = True
        self._changed.set()

    def toggle_paused(self) -> None:
        """Pause or resume."""
        if self._is_paused:
            self.resume()
        else:
            self.pause()

    def pause(self) -> None:
        """Pause the playback."""
        with self._lock:
            self._is_paused = True
            self._clock.pause()
        self._log.info("Pausing play.")
        self._changed.set()

    def resume(self) -> None:
        """Continue after `pause`."""
        with self._lock:
            self._is_paused = False
            if self._has_begun:
                self._clock.resume()
        self._log.info("Resuming play.")
        self._changed.set()

    def set_rate(self, rate: float) -> bool:
        """Set the rate. Return false if the rate is not above 0."""
        if not 0 < rate < math.inf:
            self._log.warning(f"Failed to set rate to invalid value {rate:g}")
            return False
        self._clock.set_rate(rate)
        self._log.info(f"Set rate to {rate:g}")
        self._changed.set()
        return True

    def play_next(self) -> bool:
        """Publish the next message of a paused player. Return false if the player is not paused."""
        return self.step(1)

    def burst(self, count: int = 0) -> int:
        """Publish the next messages of a paused player without waiting between them.

        The method returns when the messages are published, or at the end of the bag. It must not be
        called in the thread of `run`.

        Args:
            count: Number of messages. 0 means all.

        Returns:
            The number of messages that were published.
        """
        before = self.sent_count
        if not self.step(count):
            return 0
        with self._lock:
            self._lock.wait_for(lambda: not self._steps, _FOREVER_S)
        return self.sent_count - before

    def step(self, count: int) -> bool:
        """Let `run` publish the next messages of a paused player, and return without waiting.

        Args:
            count: Number of messages. 0 means all.

        Returns:
            False if the player is not paused.
        """
        if not self._is_paused:
            self._log.warning("Called play next, but not in paused state.")
            return False
        with self._lock:
            if not self._is_over.is_set():
                self._steps += count or math.inf
        self._changed.set()
        return True

    def seek(self, time_ns: int, *, shows_state: bool = False) -> bool:
        """Continue from another time of the recording, in nanoseconds since the epoch.

        Args:
            time_ns: The time.
            shows_state: Whether to publish first the newest message of each topic from the second
                before the time. Then subscribers show the state at that time.

        Returns:
            False if the time is after the end of the bag, or if `run` has ended.
        """
        if time_ns > self.bag_end_ns or self._is_over.is_set():
            return False
        self._shows_state = shows_state
        self._seek_ns = max(time_ns, self.bag_start_ns)
        self._changed.set()
        return True

    def press(self, key: str) -> None:
        """Carry out a key's command: space, `s`, or the last character that an arrow key sends."""
        if key == " ":
            self.toggle_paused()
        elif key == "A":
            self.set_rate(self._clock.rate * (1 + _RATE_STEP))
        elif key == "B":
            self.set_rate(self._clock.rate * (1 - _RATE_STEP))
        elif key in {"C", "s"}:
            self.play_next()

    def _play_once(self, *, is_first: bool) -> None:
        if is_first and self._options.delay > 0:
            self._log.info(f"Sleep {int(self._options.delay * S_TO_NS)} ns")
            self._is_delayed = True
            self._sleep(self._options.delay)
            self._is_delayed = False
        self._play_from(self._start_ns, is_first=is_first)
        while self._seek_ns is not None and self._is_ok():
            start_ns, self._seek_ns = self._seek_ns, None
            self._play_from(start_ns, is_first=False)

    def _play_from(self, start_ns: int, *, is_first: bool) -> None:
        messages = ReadAhead(self._messages(max(start_ns, 0)), self._options.read_ahead_queue_size)
        try:
            messages.wait_until_filled(_FILL_S)
            if is_first and messages.largest >= LARGE_BYTES:
                # The first call makes the pool of shared memory, which takes 80 ms.
                self._node.context.share(bytes(LARGE_BYTES))
            if is_first:
                self._publish_latched()
            elif self._shows_state:
                self._publish_state(start_ns)
            self._clock.set(start_ns)
            with self._lock:
                self._has_begun = True
                if not self._is_paused:
                    self._clock.resume()
            self._play(messages)
        finally:
            messages.close()

    def _messages(self, start_ns: int) -> Iterator[BagMessage]:
        topics = frozenset(self._topics)
        found = merge([bag.messages(topics, start_ns, self._end_ns()) for bag in self._bags])
        if self._options.message_order == MessageOrder.SENT_TIMESTAMP:
            return in_send_order(found, self._options.read_ahead_queue_size)
        return found

    def _play(self, messages: ReadAhead) -> None:
        for message in messages:
            topic = self._topics[message.topic]
            prepared = self._prepared(topic, message)
            if not self._wait_for(message.log_ns):
                return
            if prepared is not None:
                self._publish(topic, message, prepared)
            self._count_step()

    def _publish_latched(self) -> None:
        """Publish the transient local messages before the start. Late subscriptions expect them."""
        if self._options.start_offset <= 0:
            return
        for bag in self._bags:
            for name, topic in bag.topics.items():
                profile = profile_to_publish(topic.offered_qos_profiles)
                is_latched = profile.durability is DurabilityPolicy.TRANSIENT_LOCAL
                if not is_latched or name not in self._topics:
                    continue
                last: deque[BagMessage] = deque(maxlen=max(profile.depth, 1))
                last.extend(bag.messages([name], 0, self._start_ns - 1))
                for message in last:
                    played = self._topics[name]
                    prepared = self._prepared(played, message)
                    if prepared is not None:
                        self._publish(played, message, prepared)

    def _publish_state(self, time_ns: int) -> None:
        """Publish the newest message of each topic in the second before a time."""
        last: dict[str, BagMessage] = {}
        for bag in self._bags:
            start_ns = max(time_ns - S_TO_NS, 0)
            for message in bag.messages(frozenset(self._topics), start_ns, time_ns - 1):
                last[message.topic] = message
        for message in sorted(last.values(), key=lambda message: message.log_ns):
            topic = self._topics[message.topic]
            prepared = self._prepared(topic, message)
            if prepared is not None:
                self._publish(topic, message, prepared)

    def _end_ns(self) -> int | None:
        ends = []
        if self._options.playback_duration >= 0:
            ends.append(self._start_ns + int(self._options.playback_duration * S_TO_NS))
        if self._options.playback_until_timestamp >= 0:
            ends.append(self._options.playback_until_timestamp)
        return max(ends, default=None)

    def _prepared(self, topic: PlayedTopic, message: BagMessage) -> Any:
        """Convert a message before it is due. Return `None` if its bytes do not fit its type."""
        try:
            return topic.prepare(message.data)
        except ZbotError as error:
            topic.errors += 1
            if topic.errors == 1:
                self._log.error(f"{message.topic}: cannot read a message: {error}")
            return None

    def _publish(self, topic: PlayedTopic, message: BagMessage, prepared: Any) -> None:
        wanted = self._topics_with_clock
        if wanted is None or message.topic in wanted:
            self._publish_clock(message.log_ns)
        topic.publisher.publish(prepared)
        self.sent_count += 1

    def _wait_for(self, time_ns: int) -> bool:
        """Wait until a message is due. Return false after `seek`, or if the playback ends."""
        while self._is_ok() and self._seek_ns is None:
            if self._steps:
                self._clock.set(time_ns)
                return True
            left_s = self._clock.seconds_until(time_ns)
            if left_s <= 0:
                return True
            if left_s > _BUSY_S:
                self._changed.wait(min(left_s - _BUSY_S, _LONGEST_WAIT_S))
            else:
                time.sleep(0)  # let other threads run
        return False

    def _count_step(self) -> None:
        if self._steps:
            with self._lock:
                self._steps = max(self._steps - 1, 0)
                if not self._steps:
                    self._lock.notify_all()

    def _sleep(self, seconds: float) -> None:
        deadline = Deadline(seconds)
        while self._is_ok() and not deadline.is_over:
            self._changed.wait(deadline.left_s)

    def _is_ok(self) -> bool:
        return self._node.context.ok() and not self._is_stopped

    def _wait_for_subscribers(self) -> None:
        """Wait until the sessions with reliable subscriptions have received all messages."""
        if self._options.wait_acked_timeout < 0 or not self._is_ok():
            return
        names = [topic.name for topic in self._topics.values()]
        graph = self._node.context.graph.snapshot()
        missing = {
            subscription.zid
            for name in names
            for subscription in graph.subscriptions(name)
            if subscription.qos.reliability is ReliabilityPolicy.RELIABLE
        } - {self._node.context.zid}
        # A query takes the same links as the messages, so a session answers after the messages.
        limit_s = self._options.wait_acked_timeout / 1000 or _FOREVER_S
        for key, _ in answers(self._node.context.session, "@/*/*", limit_s):
            missing.discard(key.split("/")[1])
            if not missing or not self._is_ok():
                return
        if missing:
            self._log.error("Timed out while waiting for all published messages to be acknowledged")

    def _create_clock(self) -> Publisher[Any] | None:
        if self._options.clock_publish_frequency <= 0 and self._topics_with_clock == frozenset():
            return None
        from rosgraph_msgs.msg import Clock  # noqa: PLC0415 - the import makes the class

        self._clock_class: Any = Clock
        return self._node.create_publisher(Clock, CLOCK_TOPIC, _CLOCK_QOS)

    def _publish_clock(self, time_ns: int) -> None:
        if self._clock_publisher is not None:
            stamp = Time(nanoseconds=max(time_ns, 0)).to_msg()
            self._clock_publisher.publish(self._clock_class(clock=stamp))

    def _tick(self) -> None:
        try:
            while self._is_ok():
                self._publish_clock(self._clock.now_ns())
                if self._is_over.wait(1 / self._options.clock_publish_frequency):
                    return
        except NotInitializedError:
            return  # the context was shut down at the same time
