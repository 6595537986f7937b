"""Tasks that report the health of a device: ROS 2's package `diagnostic_updater`.

A task is a function or an object that fills in a status. An `Updater` runs all tasks of a node at a
fixed rate, and publishes their statuses on `/diagnostics`.
"""

from __future__ import annotations

import threading
from collections import deque
from typing import TYPE_CHECKING, Any, TypeAlias

from zbot.errors import WrongTypeError
from zbot.executor.clock import Clock
from zbot.time import S_TO_NS, ClockType, Time

from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from zbot.node.node import Node
    from zbot.node.publisher import Publisher

    #: A task's function. It gets a status, fills it in and returns it.
    Fill: TypeAlias = Callable[["DiagnosticStatusWrapper"], "DiagnosticStatusWrapper"]

_PERIOD, _FULL_NAMES = "diagnostic_updater.period", "diagnostic_updater.use_fqn"
_OK, _WARN, _ERROR = DiagnosticStatus.OK, DiagnosticStatus.WARN, DiagnosticStatus.ERROR


class DiagnosticStatusWrapper(DiagnosticStatus):
    """Status with methods that fill it in."""

    def summary(self, *args: Any) -> None:
        """Set level and message: `summary(level, message)` or `summary(status)`."""
        self.level, self.message = _level_and_message(args)

    def clearSummary(self) -> None:
        """Set the level OK and an empty message."""
        self.summary(_OK, "")

    def mergeSummary(self, *args: Any) -> None:
        """Add another level and message, or those of a status.

        The worse level is kept. Messages are joined by `; ` if both levels are OK, or if none is.
        """
        level, message = _level_and_message(args)
        if (level > _OK) == (self.level > _OK):
            self.message = f"{self.message}; {message}" if self.message else message
        elif level > self.level:
            self.message = message
        self.level = max(self.level, level)

    def add(self, key: str, val: Any) -> None:
        """Add a value with a name. A value that is no text is added as its text."""
        self.values.append(KeyValue(key=key, value=str(val)))


def _level_and_message(args: tuple[Any, ...]) -> tuple[bytes, str]:
    if len(args) == 1:
        return args[0].level, args[0].message
    level, message = args
    return level, str(message)


class DiagnosticTask:
    """Task with a name. Subclasses fill in the status in `run`."""

    def __init__(self, name: str) -> None:
        self.name = name

    def getName(self) -> str:
        """Return the name."""
        return self.name

    def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        """Fill in the status, and return it."""
        return stat


class FunctionDiagnosticTask(DiagnosticTask):
    """Task whose status a function fills in."""

    def __init__(self, name: str, fn: Fill) -> None:
        super().__init__(name)
        self.fn = fn

    def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        """Call the function.

        Raises:
            WrongTypeError: The function returns no status.
        """
        filled = self.fn(stat)
        if not isinstance(filled, DiagnosticStatus):
            raise WrongTypeError(f"the diagnostic task '{self.name}' must end with `return stat`")
        return filled


class CompositeDiagnosticTask(DiagnosticTask):
    """Task with one status for several tasks: the worst level, and all values."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.tasks: list[DiagnosticTask] = []

    def addTask(self, t: DiagnosticTask) -> None:
        """Add a task."""
        self.tasks.append(t)

    def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        """Run the tasks, and merge their summaries."""
        given, merged = DiagnosticStatusWrapper(), DiagnosticStatusWrapper()
        given.summary(stat)
        for task in self.tasks:
            stat.summary(given)
            stat = task.run(stat)
            merged.mergeSummary(stat)
        stat.summary(merged)
        return stat


class DiagnosticTaskVector:
    """List of tasks. All methods may be called from any thread."""

    def __init__(self) -> None:
        self.tasks: list[DiagnosticTask] = []
        self.lock = threading.Lock()

    def add(self, *args: Any) -> None:
        """Add a task: `add(task)` or `add(name, function)`."""
        task = args[0] if len(args) == 1 else FunctionDiagnosticTask(*args)
        with self.lock:
            # The task may change its name later.
            self.tasks.append(FunctionDiagnosticTask(task.getName(), task.run))
            self.addedTaskCallback(self.tasks[-1])

    def addedTaskCallback(self, task: DiagnosticTask) -> None:
        """React to a new task. Subclasses may override this method."""

    def removeByName(self, name: str) -> bool:
        """Remove the first task with a name. Return whether there was one."""
        with self.lock:
            found = next((task for task in self.tasks if task.name == name), None)
            if found is not None:
                self.tasks.remove(found)
        return found is not None


class Updater(DiagnosticTaskVector):
    """Runs the tasks of a node, and publishes their statuses on `/diagnostics`.

    The executor of the node runs the tasks. The parameter `diagnostic_updater.use_fqn` decides
    whether the names of statuses begin with the full name of the node.

    Args:
        node: The node.
        period: Seconds between two runs. The parameter `diagnostic_updater.period` may change it.
    """

    def __init__(self, node: Node, period: float = 1.0) -> None:
        super().__init__()
        self.node = node
        self.publisher = node.create_publisher(DiagnosticArray, "/diagnostics", 1)
        self._period = float(_setting(node, _PERIOD, float(period)))
        self.timer = node.create_timer(self._period, self.update)
        self.verbose = False  #: whether the log has each status that is not OK
        self.hwid = ""
        self.warn_nohwid_done = False
        is_full = _setting(node, _FULL_NAMES, False)
        self.node_name = node.get_fully_qualified_name() if is_full else node.get_name()

    @property
    def period(self) -> float:
        """Seconds between two runs."""
        return self._period

    @period.setter
    def period(self, period: float) -> None:
        self._period = period
        self.node.destroy_timer(self.timer)
        self.timer = self.node.create_timer(period, self.update)

    def setHardwareID(self, hwid: str) -> None:
        """Set the id of the device, which all statuses have."""
        self.hwid = hwid

    def update(self) -> None:
        """Run all tasks now, and publish their statuses."""
        with self.lock:  # no task is added meanwhile
            statuses = [
                task.run(self._status(task, _ERROR, "No message was set")) for task in self.tasks
            ]
        wrong = [status for status in statuses if status.level != _OK]
        for status in wrong if self.verbose else ():
            self.node.get_logger().warning(
                f"Non-zero diagnostic status. Name: {status.name}, status {status.level!r}: "
                f"{status.message}"
            )
        if not (self.hwid or wrong or self.warn_nohwid_done):
            self.node.get_logger().warning(
                "diagnostic_updater: No HW_ID was set. Call setHardwareID, with 'none' if the "
                "device has no id"
            )
            self.warn_nohwid_done = True
        self.publish(statuses)

    def force_update(self) -> None:
        """Run all tasks now, and publish their statuses."""
        self.update()

    def broadcast(self, lvl: bytes, msg: str) -> None:
        """Publish the same level and message for all tasks, e.g. before the node ends."""
        self.publish([self._status(task, lvl, msg) for task in self.tasks])

    def publish(self, msg: DiagnosticStatus | Iterable[DiagnosticStatus]) -> None:
        """Publish statuses, with the name of the node before their names."""
        statuses = [msg] if isinstance(msg, DiagnosticStatus) else msg
        array = DiagnosticArray()
        array.header.stamp = self.node.get_clock().now().to_msg()
        array.status = [
            DiagnosticStatus(
                level=status.level,
                name=f"{self.node_name}: {status.name}",
                message=status.message,
                hardware_id=status.hardware_id,
                values=status.values,
            )
            for status in statuses
        ]
        self.publisher.publish(array)

    def addedTaskCallback(self, task: DiagnosticTask) -> None:
        """Publish that the task is starting."""
        self.publish(self._status(task, _OK, "Node starting up"))

    def _status(self, task: DiagnosticTask, level: bytes, message: str) -> DiagnosticStatusWrapper:
        return DiagnosticStatusWrapper(
            level=level, name=task.name, message=message, hardware_id=self.hwid
        )


def _setting(node: Node, name: str, default: Any) -> Any:
    if not node.has_parameter(name):
        node.declare_parameter(name, default)
    return node.get_parameter(name).value


def _now_ns() -> int:
    return Clock(clock_type=ClockType.ROS_TIME).now().nanoseconds


class FrequencyStatusParam:
    """Limits of a frequency.

    Args:
        freq_bound: Dictionary with `min` and perhaps `max` in Hz. It is read in each run.
        tolerance: Share by which the frequency may exceed the limits.
        window_size: Number of runs whose events are counted together.
    """

    def __init__(
        self, freq_bound: dict[str, float], tolerance: float = 0.1, window_size: int = 5
    ) -> None:
        self.freq_bound = freq_bound
        self.tolerance = tolerance
        self.window_size = window_size

    def limits(self) -> tuple[float, float | None]:
        """Return the lowest and the highest frequency, with the tolerance."""
        low = self.freq_bound["min"] * (1 - self.tolerance)
        high = self.freq_bound.get("max")
        return low, None if high is None else high * (1 + self.tolerance)


class FrequencyStatus(DiagnosticTask):
    """Task that compares how often `tick` is called with limits."""

    def __init__(self, params: FrequencyStatusParam, name: str = "FrequencyStatus") -> None:
        super().__init__(name)
        self.params = params
        self.lock = threading.Lock()
        self.clear()

    def clear(self) -> None:
        """Forget all events."""
        with self.lock:
            self.count = 0
            size = self.params.window_size
            self._runs = deque([(0, _now_ns())] * size, maxlen=size)  # count and time of each run

    def tick(self) -> None:
        """Count an event."""
        with self.lock:
            self.count += 1

    def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        """Compare the frequency of the last runs with the limits."""
        with self.lock:
            now_ns, total, (count, begin_ns) = _now_ns(), self.count, self._runs[0]
            self._runs.append((total, now_ns))
        events, window_s = total - count, (now_ns - begin_ns) / S_TO_NS
        frequency = events / window_s if window_s > 0 else 0.0
        low, high = self.params.limits()
        if events == 0:
            stat.summary(_ERROR, "No events recorded.")
        elif frequency < low:
            stat.summary(_WARN, "Frequency too low.")
        elif high is not None and frequency > high:
            stat.summary(_WARN, "Frequency too high.")
        else:
            stat.summary(_OK, "Desired frequency met")
        stat.add("Events in window", events)
        stat.add("Events since startup", total)
        stat.add("Duration of window (s)", f"{window_s:f}")
        stat.add("Actual frequency (Hz)", f"{frequency:f}")
        if self.params.freq_bound.get("max") == self.params.freq_bound["min"]:
            stat.add("Target frequency (Hz)", f"{self.params.freq_bound['min']:f}")
        if low > 0:
            stat.add("Minimum acceptable frequency (Hz)", f"{low:f}")
        if high is not None:
            stat.add("Maximum acceptable frequency (Hz)", f"{high:f}")
        return stat


class TimeStampStatusParam:
    """Limits of the age of time stamps in seconds. A negative age is in the future."""

    def __init__(self, min_acceptable: float = -1, max_acceptable: float = 5) -> None:
        self.min_acceptable = min_acceptable
        self.max_acceptable = max_acceptable


class TimeStampStatus(DiagnosticTask):
    """Task that compares the ages of time stamps with limits."""

    def __init__(
        self, params: TimeStampStatusParam | None = None, name: str = "Timestamp Status"
    ) -> None:
        super().__init__(name)
        self.params = params or TimeStampStatusParam()
        self.lock = threading.Lock()
        self.early_count = self.late_count = self.zero_count = 0
        self._ages: tuple[float, float] | None = None  # the lowest and the highest since a run
        self._has_zero = False

    def tick(self, stamp: float | Time) -> None:
        """Take the time stamp of an event: seconds, or a time."""
        seconds = stamp.nanoseconds / S_TO_NS if isinstance(stamp, Time) else float(stamp)
        with self.lock:
            if seconds == 0:
                self._has_zero = True
                return
            age = _now_ns() / S_TO_NS - seconds
            low, high = self._ages or (age, age)
            self._ages = min(low, age), max(high, age)

    def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        """Compare the ages since the last run with the limits."""
        with self.lock:
            ages, self._ages = self._ages, None
            has_zero, self._has_zero = self._has_zero, False
        youngest, oldest = ages or (0.0, 0.0)
        low, high = self.params.min_acceptable, self.params.max_acceptable
        stat.summary(_OK, "Timestamps are reasonable.")
        if ages is None:
            stat.summary(_WARN, "No data since last update.")
        elif youngest < low:
            stat.summary(_ERROR, "Timestamps too far in future seen.")
            self.early_count += 1
        if ages is not None and oldest > high:
            stat.summary(_ERROR, "Timestamps too far in past seen.")
            self.late_count += 1
        if has_zero:
            stat.summary(_ERROR, "Zero timestamp seen.")
            self.zero_count += 1
        stat.add("Earliest timestamp delay:", f"{youngest:f}")
        stat.add("Latest timestamp delay:", f"{oldest:f}")
        stat.add("Earliest acceptable timestamp delay:", f"{low:f}")
        stat.add("Latest acceptable timestamp delay:", f"{high:f}")
        stat.add("Late diagnostic update count:", self.late_count)
        stat.add("Early diagnostic update count:", self.early_count)
        stat.add("Zero seen diagnostic update count:", self.zero_count)
        return stat


class Heartbeat(DiagnosticTask):
    """Task that is always OK: the node is alive."""

    def __init__(self) -> None:
        super().__init__("Heartbeat")

    def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        """Set the level OK."""
        stat.summary(_OK, "Alive")
        return stat


class HeaderlessTopicDiagnostic(CompositeDiagnosticTask):
    """Task that checks how often messages are published. It adds itself to an updater."""

    def __init__(self, name: str, diag: DiagnosticTaskVector, freq: FrequencyStatusParam) -> None:
        super().__init__(f"{name} topic status")
        self.diag = diag
        self.freq = FrequencyStatus(freq)
        self.addTask(self.freq)
        diag.add(self)

    def tick(self) -> None:
        """Count a message."""
        self.freq.tick()

    def clear_window(self) -> None:
        """Forget all messages."""
        self.freq.clear()


class TopicDiagnostic(HeaderlessTopicDiagnostic):
    """Task that checks how often messages are published, and their time stamps."""

    def __init__(
        self,
        name: str,
        diag: DiagnosticTaskVector,
        freq: FrequencyStatusParam,
        stamp: TimeStampStatusParam,
    ) -> None:
        super().__init__(name, diag, freq)
        self.stamp = TimeStampStatus(stamp)
        self.addTask(self.stamp)

    def tick(self, stamp: float | Time) -> None:  # type: ignore[override]  # ROS 2's signature
        """Count a message with a time stamp."""
        self.stamp.tick(stamp)
        super().tick()


class DiagnosedPublisher(TopicDiagnostic):
    """Publisher of messages with a header, and the task that checks them."""

    def __init__(
        self,
        pub: Publisher[Any],
        diag: DiagnosticTaskVector,
        freq: FrequencyStatusParam,
        stamp: TimeStampStatusParam,
    ) -> None:
        super().__init__(pub.topic_name, diag, freq, stamp)
        self.publisher = pub

    def publish(self, message: Any) -> None:
        """Publish a message, and check its time stamp."""
        self.tick(Time.from_msg(message.header.stamp))
        self.publisher.publish(message)
