"""Simulated time."""

from zbot.executor.clock import ROSClock as ROSClock
from zbot.node.time_source import CLOCK_TOPIC as CLOCK_TOPIC
from zbot.node.time_source import TimeSource as TimeSource
from zbot.parameters.parameter import Parameter as Parameter
from zbot.qos import QoSProfile as QoSProfile
from zbot.qos import ReliabilityPolicy as ReliabilityPolicy
from zbot.time import ClockType as ClockType
from zbot.time import Time as Time

from rcl_interfaces.msg import SetParametersResult as SetParametersResult

USE_SIM_TIME_NAME = "use_sim_time"
