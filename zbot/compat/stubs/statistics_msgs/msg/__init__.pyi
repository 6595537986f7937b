# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
import statistics_msgs.msg
from zbot.interfaces import Action, Message, Service

class MetricsMessage(Message):
    """statistics_msgs/msg/MetricsMessage

    # What was measured during a stretch of time, such as the age of messages on a topic.

    # Who or what was measured: a node, a topic, a process.
    string measurement_source_name

    # Which quantity, such as 'message_age' or 'message_period'.
    string metrics_source

    # Its unit, such as 'ms'.
    string unit

    # Beginning of the stretch.
    builtin_interfaces/Time window_start

    # Its end.
    builtin_interfaces/Time window_stop

    # The results, one per kind.
    StatisticDataPoint[] statistics
    """
    def __init__(self, *, measurement_source_name: str = ..., metrics_source: str = ..., unit: str = ..., window_start: builtin_interfaces.msg.Time = ..., window_stop: builtin_interfaces.msg.Time = ..., statistics: Collection[statistics_msgs.msg.StatisticDataPoint] = ..., check_fields: bool = ...) -> None: ...
    measurement_source_name: str
    metrics_source: str
    unit: str
    window_start: builtin_interfaces.msg.Time
    window_stop: builtin_interfaces.msg.Time
    @property
    def statistics(self) -> list[statistics_msgs.msg.StatisticDataPoint]: ...
    @statistics.setter
    def statistics(self, value: Collection[statistics_msgs.msg.StatisticDataPoint]) -> None: ...

class StatisticDataPoint(Message):
    """statistics_msgs/msg/StatisticDataPoint

    # One result of a measurement.

    # Which kind of result, one of the constants in StatisticDataType.
    uint8 data_type

    # The result; NaN if there were too few measurements. Never infinite.
    float64 data
    """
    def __init__(self, *, data_type: int = ..., data: float = ..., check_fields: bool = ...) -> None: ...
    data_type: int
    data: float

class StatisticDataType(Message):
    """statistics_msgs/msg/StatisticDataType

    # The kinds of result of a measurement. Holds constants only.

    # Not filled in.
    uint8 STATISTICS_DATA_TYPE_UNINITIALIZED = 0

    # Mean, smallest, largest, standard deviation, and how many measurements there were.
    uint8 STATISTICS_DATA_TYPE_AVERAGE = 1
    uint8 STATISTICS_DATA_TYPE_MINIMUM = 2
    uint8 STATISTICS_DATA_TYPE_MAXIMUM = 3
    uint8 STATISTICS_DATA_TYPE_STDDEV = 4
    uint8 STATISTICS_DATA_TYPE_SAMPLE_COUNT = 5
    """
    STATISTICS_DATA_TYPE_UNINITIALIZED: Final = 0
    STATISTICS_DATA_TYPE_AVERAGE: Final = 1
    STATISTICS_DATA_TYPE_MINIMUM: Final = 2
    STATISTICS_DATA_TYPE_MAXIMUM: Final = 3
    STATISTICS_DATA_TYPE_STDDEV: Final = 4
    STATISTICS_DATA_TYPE_SAMPLE_COUNT: Final = 5
    def __init__(self, *, check_fields: bool = ...) -> None: ...
