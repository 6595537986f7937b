"""Publisher of one sensor of a browser."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any
from weakref import WeakKeyDictionary

from zbot.observer.errors import ViewerError
from zbot.observer.rate_meter import RateMeter
from zbot.web.panels.sensors import sensor_message
from zbot.web.panels.sensors.sensor_kind import (
    CAMERA,
    CAMERA_INFO,
    MICROPHONE,
    MOTION,
    camera_info_topic,
)
from zbot.web.panels.sensors.sensor_problem import taken_topic

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from zbot.observer.system import System
    from zbot.web.panels.sensors.sensor_kind import SensorKind

_BURST = 10
#: The topics that browsers publish now.
_TAKEN: WeakKeyDictionary[System, set[str]] = WeakKeyDictionary()


class RateLimit:
    """Limit of events a second. A few events may come together.

    Args:
        most_hz: The limit.
        clock: Function that returns seconds.
    """

    def __init__(self, most_hz: float, clock: Callable[[], float] = time.monotonic) -> None:
        self._most_hz, self._clock = most_hz, clock
        self._left, self._then_s = float(_BURST), clock()

    def allows(self) -> bool:
        """Return whether an event may happen now. Then it counts."""
        now_s = self._clock()
        self._left = min(_BURST, self._left + (now_s - self._then_s) * self._most_hz)
        self._then_s = now_s
        if self._left < 1:
            return False
        self._left -= 1
        return True


class SensorPublisher:
    """Publisher of one sensor of one browser, until `release`.

    Args:
        system: The running system.
        kind: The kind of the sensor.
        topic: The topic's full name.
        frame_id: The frame of the messages.

    Raises:
        ViewerError: The page is read-only, or another browser publishes the topic.
        InvalidTopicNameError: The name is not valid in ROS 2.

    Attributes:
        count: The number of published readings.
    """

    def __init__(self, system: System, kind: SensorKind, topic: str, frame_id: str) -> None:
        self.kind, self.topic, self.count = kind, topic, 0
        self._system, self._frame_id = system, frame_id
        self._limit, self._meter = RateLimit(kind.most_hz), RateMeter()
        self._taken = _TAKEN.setdefault(system, set())
        if topic in self._taken:
            raise ViewerError(taken_topic(topic))
        topics = [(topic, kind.type_name)]
        if kind is CAMERA:
            topics.append((camera_info_topic(topic), CAMERA_INFO))
        self._references = [system.publisher(*one) for one in topics]
        self._taken.add(topic)

    @property
    def rate_hz(self) -> float:
        """Published readings a second."""
        return self._meter.rates(time.monotonic_ns())[0]

    def take(self, reading: Sequence[Any]) -> bool:
        """Publish a reading of the browser. Return False if it is not right, or one too many."""
        if not self._limit.allows():
            return False
        messages = self._messages(reading)
        if messages is None or not all(one.entity.is_open for one in self._references):
            return False
        for reference, message in zip(self._references, messages, strict=True):
            reference.entity.publish(message)
        self.count += 1
        self._meter.add(time.monotonic_ns(), 0)
        return True

    def _messages(self, reading: Sequence[Any]) -> tuple[Any, ...] | None:
        # The clock of the browser may be wrong, so the stamp is the time of the arrival.
        stamp = self._system.node.get_clock().now().to_msg()
        if self.kind is CAMERA:
            return sensor_message.picture(reading, stamp, self._frame_id)
        if self.kind is MICROPHONE:
            message = sensor_message.level(reading)
        elif self.kind is MOTION:
            message = sensor_message.imu(reading, stamp, self._frame_id)
        else:
            message = sensor_message.fix(reading, stamp, self._frame_id)
        return None if message is None else (message,)

    def release(self) -> None:
        """Stop publishing. A second call does nothing."""
        if self._references:
            self._taken.discard(self.topic)
        while self._references:
            self._references.pop().release()
