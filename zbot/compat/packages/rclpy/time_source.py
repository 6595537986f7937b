# Written by python -m zbot.compat.generator; do not edit.
"""Simulated time."""

from zbot.executor.clock import ROSClock
from zbot.node.time_source import CLOCK_TOPIC, TimeSource
from zbot.parameters.parameter import Parameter
from zbot.qos import QoSProfile, ReliabilityPolicy
from zbot.time import ClockType, Time
from rcl_interfaces.msg import SetParametersResult
from zbot.compat.constants import USE_SIM_TIME_NAME

__all__ = [
    "CLOCK_TOPIC",
    "ClockType",
    "Parameter",
    "QoSProfile",
    "ROSClock",
    "ReliabilityPolicy",
    "SetParametersResult",
    "Time",
    "TimeSource",
    "USE_SIM_TIME_NAME",
]
