# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `tf2_ros`: transforms between frames."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
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
    "ActionClient",
    "Buffer",
    "BufferClient",
    "BufferCore",
    "BufferInterface",
    "BufferServer",
    "Clock",
    "ConnectivityException",
    "ConvertRegistration",
    "DurabilityPolicy",
    "Duration",
    "ExtrapolationException",
    "FrameGraph",
    "Future",
    "Header",
    "HistoryPolicy",
    "InvalidArgumentException",
    "JumpThreshold",
    "LookupException",
    "LookupTransform",
    "Node",
    "NotImplementedException",
    "PointCloud2",
    "PointStamped",
    "PoseStamped",
    "PoseWithCovarianceStamped",
    "QoSProfile",
    "ReentrantCallbackGroup",
    "SingleThreadedExecutor",
    "StaticTransformBroadcaster",
    "StaticTransformListener",
    "TFMessage",
    "Time",
    "TimeJump",
    "TimeoutException",
    "TransformBroadcaster",
    "TransformException",
    "TransformListener",
    "TransformRegistration",
    "TransformStamped",
    "TypeException",
    "Vector3Stamped",
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
    from geometry_msgs.msg import PointStamped as PointStamped
    from geometry_msgs.msg import PoseStamped as PoseStamped
    from geometry_msgs.msg import PoseWithCovarianceStamped as PoseWithCovarianceStamped
    from geometry_msgs.msg import Vector3Stamped as Vector3Stamped
    from sensor_msgs.msg import PointCloud2 as PointCloud2
    from std_msgs.msg import Header as Header
    from tf2_msgs.action import LookupTransform as LookupTransform
    from tf2_msgs.msg import TFMessage as TFMessage
    from tf2_msgs.srv import FrameGraph as FrameGraph
    from zbot.action.client import ActionClient as ActionClient
    from zbot.executor.callback_group import ReentrantCallbackGroup as ReentrantCallbackGroup
    from zbot.executor.clock import Clock as Clock
    from zbot.executor.clock import JumpThreshold as JumpThreshold
    from zbot.executor.clock import TimeJump as TimeJump
    from zbot.executor.single_threaded_executor import SingleThreadedExecutor as SingleThreadedExecutor
    from zbot.executor.task import Future as Future
    from zbot.node.node import Node as Node
    from zbot.qos import DurabilityPolicy as DurabilityPolicy
    from zbot.qos import HistoryPolicy as HistoryPolicy
    from zbot.qos import QoSProfile as QoSProfile
    from zbot.time import Duration as Duration
    from zbot.time import Time as Time
else:
    __getattr__ = lazy_names(
        __name__,
        {
            "zbot.tf2.remote_buffer": "BufferClient BufferServer",
            "geometry_msgs.msg": "PointStamped PoseStamped PoseWithCovarianceStamped Vector3Stamped",
            "sensor_msgs.msg": "PointCloud2",
            "std_msgs.msg": "Header",
            "tf2_msgs.action": "LookupTransform",
            "tf2_msgs.msg": "TFMessage",
            "tf2_msgs.srv": "FrameGraph",
            "zbot.action.client": "ActionClient",
            "zbot.executor.callback_group": "ReentrantCallbackGroup",
            "zbot.executor.clock": "Clock JumpThreshold TimeJump",
            "zbot.executor.single_threaded_executor": "SingleThreadedExecutor",
            "zbot.executor.task": "Future",
            "zbot.node.node": "Node",
            "zbot.qos": "DurabilityPolicy HistoryPolicy QoSProfile",
            "zbot.time": "Duration Time",
        },
        submodules=(
            "buffer",
            "buffer_client",
            "buffer_interface",
            "static_transform_broadcaster",
            "static_transform_listener",
            "transform_broadcaster",
            "transform_listener",
        ),
    )[0]
