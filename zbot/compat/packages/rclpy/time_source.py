"""Simulated time."""

from zbot.executor.clock import ROSClock
from zbot.node.time_source import CLOCK_TOPIC, TimeSource
from zbot.parameters.parameter import Parameter
from zbot.qos import QoSProfile, ReliabilityPolicy
from zbot.time import ClockType, Time

from rcl_interfaces.msg import SetParametersResult

USE_SIM_TIME_NAME = "use_sim_time"
