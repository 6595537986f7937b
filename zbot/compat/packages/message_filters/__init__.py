"""ROS 2's `message_filters`: messages that belong together."""

from zbot.message_filter import ApproximateTimeSynchronizer as ApproximateTimeSynchronizer
from zbot.message_filter import Cache as Cache
from zbot.message_filter import Chain as Chain
from zbot.message_filter import SimpleFilter as SimpleFilter
from zbot.message_filter import Subscriber as Subscriber
from zbot.message_filter import TimeSynchronizer as TimeSynchronizer
