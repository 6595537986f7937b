"""ROS 2's `tf2_py`: the tree of frames without nodes."""

from zbot.tf2.buffer_core import BufferCore as BufferCore
from zbot.tf2.errors import ConnectivityException as ConnectivityException
from zbot.tf2.errors import ExtrapolationException as ExtrapolationException
from zbot.tf2.errors import InvalidArgumentException as InvalidArgumentException
from zbot.tf2.errors import LookupException as LookupException
from zbot.tf2.errors import TimeoutException as TimeoutException
from zbot.tf2.errors import TransformException as TransformException
