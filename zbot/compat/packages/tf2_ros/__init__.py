# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `tf2_ros`: transforms between frames."""

from typing import TYPE_CHECKING

from zbot.compat.first_use import at_first_use
from zbot.tf2.broadcaster import StaticTransformBroadcaster, TransformBroadcaster
from zbot.tf2.buffer import Buffer
from zbot.tf2.buffer_core import BufferCore
from zbot.tf2.buffer_interface import (
    BufferInterface,
    ConvertRegistration,
    TransformRegistration,
    convert,
)
from zbot.tf2.errors import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    NotImplementedException,
    TimeoutException,
    TransformException,
    TypeException,
)
from zbot.tf2.listener import StaticTransformListener, TransformListener
from geometry_msgs.msg import TransformStamped

__all__ = [
    "Buffer",
    "BufferClient",
    "BufferCore",
    "BufferInterface",
    "BufferServer",
    "ConnectivityException",
    "ConvertRegistration",
    "ExtrapolationException",
    "InvalidArgumentException",
    "LookupException",
    "NotImplementedException",
    "StaticTransformBroadcaster",
    "StaticTransformListener",
    "TimeoutException",
    "TransformBroadcaster",
    "TransformException",
    "TransformListener",
    "TransformRegistration",
    "TransformStamped",
    "TypeException",
    "convert",
]

if TYPE_CHECKING:
    from . import buffer as buffer
    from . import buffer_client as buffer_client
    from . import buffer_interface as buffer_interface
    from . import static_transform_broadcaster as static_transform_broadcaster
    from . import static_transform_listener as static_transform_listener
    from . import transform_broadcaster as transform_broadcaster
    from . import transform_listener as transform_listener
    from zbot.tf2.remote_buffer import BufferClient as BufferClient
    from zbot.tf2.remote_buffer import BufferServer as BufferServer
else:
    __getattr__ = at_first_use(
        __name__,
        "buffer",
        "buffer_client",
        "buffer_interface",
        "static_transform_broadcaster",
        "static_transform_listener",
        "transform_broadcaster",
        "transform_listener",
        BufferClient="zbot.tf2.remote_buffer",
        BufferServer="zbot.tf2.remote_buffer",
    )
