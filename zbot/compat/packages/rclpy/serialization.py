# Written by python -m zbot.compat.generator; do not edit.
"""Messages as bytes, in ROS 2's CDR."""

from zbot.interfaces.message import Message as Msg
from zbot.interfaces.python_class import MsgT, check_for_type_support
from zbot.wire.serialization import deserialize_message, serialize_message

__all__ = [
    "Msg",
    "MsgT",
    "check_for_type_support",
    "deserialize_message",
    "serialize_message",
]
