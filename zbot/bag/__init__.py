"""Bags: recordings of topics in files, in the format of ROS 2's rosbag2 (MCAP).

    for topic, msg, t in zbot.bag.read("lesson"):
        print(topic, msg, t)

This needs the extra `bag`: `pip install "zbot[bag]"`.
"""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names

if TYPE_CHECKING:
    from zbot.bag.columns import to_numpy as to_numpy
    from zbot.bag.columns import to_pandas as to_pandas
    from zbot.bag.errors import BagError as BagError
    from zbot.bag.message import BagMessage as BagMessage
    from zbot.bag.metadata import BagMetadata as BagMetadata
    from zbot.bag.metadata import TopicMetadata as TopicMetadata
    from zbot.bag.reader import Reader as Reader
    from zbot.bag.reader import read as read
    from zbot.bag.writer import Writer as Writer

_MODULES = {
    "zbot.bag.columns": "to_numpy to_pandas",
    "zbot.bag.errors": "BagError",
    "zbot.bag.message": "BagMessage",
    "zbot.bag.metadata": "BagMetadata TopicMetadata",
    "zbot.bag.reader": "Reader read",
    "zbot.bag.writer": "Writer",
}

__getattr__, __dir__ = lazy_names(__name__, _MODULES)
