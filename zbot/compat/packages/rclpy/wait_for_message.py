"""One message of a topic."""

from zbot.executor.signal_guard_condition import (
    SignalHandlerGuardCondition as SignalHandlerGuardCondition,
)
from zbot.interfaces.type_support import MsgT as MsgT
from zbot.node.node import Node as Node
from zbot.node.wait_for_message import wait_for_message as wait_for_message
from zbot.qos import QoSProfile as QoSProfile
from zbot.time import timeout_sec_to_nsec as timeout_sec_to_nsec
