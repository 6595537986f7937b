"""ROS 2's `message_filters`: messages that belong together."""

from zbot.libraries.message_filter import ApproximateTimeSynchronizer as ApproximateTimeSynchronizer
from zbot.libraries.message_filter import Cache as Cache
from zbot.libraries.message_filter import Chain as Chain
from zbot.libraries.message_filter import SimpleFilter as SimpleFilter
from zbot.libraries.message_filter import Subscriber as Subscriber
from zbot.libraries.message_filter import TimeSynchronizer as TimeSynchronizer
