# Written by python -m zbot.compat.generator; do not edit.
"""Function that waits for one message of a topic."""

from zbot.executor.guard_condition import SignalHandlerGuardCondition
from zbot.interfaces.python_class import MsgT
from zbot.node.node import Node
from zbot.qos import QoSProfile
from zbot.remote.wait_for_message import wait_for_message
from zbot.time import timeout_sec_to_nsec

__all__ = [
    "MsgT",
    "Node",
    "QoSProfile",
    "SignalHandlerGuardCondition",
    "timeout_sec_to_nsec",
    "wait_for_message",
]
