"""ROS 2's `tf2_ros`: where frames are."""

import importlib
from typing import Any

from zbot.compat.submodules import submodules
from zbot.tf2.broadcaster import StaticTransformBroadcaster as StaticTransformBroadcaster
from zbot.tf2.broadcaster import TransformBroadcaster as TransformBroadcaster
from zbot.tf2.buffer import Buffer as Buffer
from zbot.tf2.buffer_core import BufferCore as BufferCore
from zbot.tf2.buffer_interface import BufferInterface as BufferInterface
from zbot.tf2.buffer_interface import ConvertRegistration as ConvertRegistration
from zbot.tf2.buffer_interface import TransformRegistration as TransformRegistration
from zbot.tf2.buffer_interface import convert as convert
from zbot.tf2.errors import ConnectivityException as ConnectivityException
from zbot.tf2.errors import ExtrapolationException as ExtrapolationException
from zbot.tf2.errors import InvalidArgumentException as InvalidArgumentException
from zbot.tf2.errors import LookupException as LookupException
from zbot.tf2.errors import NotImplementedException as NotImplementedException
from zbot.tf2.errors import TimeoutException as TimeoutException
from zbot.tf2.errors import TransformException as TransformException
from zbot.tf2.errors import TypeException as TypeException
from zbot.tf2.listener import StaticTransformListener as StaticTransformListener
from zbot.tf2.listener import TransformListener as TransformListener

from geometry_msgs.msg import TransformStamped as TransformStamped

_submodule = submodules(
    __name__,
    "buffer",
    "buffer_client",
    "buffer_interface",
    "static_transform_broadcaster",
    "static_transform_listener",
    "transform_broadcaster",
    "transform_listener",
)


def __getattr__(name: str) -> Any:
    # Few programs ask other nodes' buffers, and the actions that this takes cost time.
    if name in {"BufferClient", "BufferServer"}:
        return getattr(importlib.import_module("zbot.tf2.remote_buffer"), name)
    return _submodule(name)
