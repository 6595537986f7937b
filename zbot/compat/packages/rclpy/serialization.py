"""Messages as bytes, in ROS 2's CDR."""

from zbot.interfaces.message import Message as Msg
from zbot.interfaces.type_support import MsgT as MsgT
from zbot.interfaces.type_support import check_for_type_support as check_for_type_support
from zbot.wire.serialization import deserialize_message as deserialize_message
from zbot.wire.serialization import serialize_message as serialize_message
