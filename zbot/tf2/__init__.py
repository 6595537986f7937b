"""Transforms between coordinate frames over time.

    buffer = Buffer()
    listener = TransformListener(buffer, node)
    pose = buffer.lookup_transform("map", "base_link", Time())

Names and meanings are the same as in ROS 2's tf2_ros.
"""

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
