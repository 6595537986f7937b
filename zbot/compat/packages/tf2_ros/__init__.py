"""ROS 2's `tf2_ros`: transforms between frames."""

import importlib
from typing import Any

from zbot.compat.submodules import submodules
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
    # Import these classes only when a program uses them. Few programs use another node's buffer,
    # and the import of actions takes time.
    if name in {"BufferClient", "BufferServer"}:
        return getattr(importlib.import_module("zbot.tf2.remote_buffer"), name)
    return _submodule(name)
