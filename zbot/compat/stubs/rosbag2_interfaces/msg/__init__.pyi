# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

from zbot.interfaces import Action, Message, Service

class ReadSplitEvent(Message):
    """rosbag2_interfaces/msg/ReadSplitEvent

    # Says that a player has finished a file of a bag and opened the next one.

    # Path of the finished file.
    string closed_file

    # Path of the next file.
    string opened_file

    # Full name of the player's node.
    string node_name
    """
    def __init__(self, *, closed_file: str = ..., opened_file: str = ..., node_name: str = ..., check_fields: bool = ...) -> None: ...
    closed_file: str
    opened_file: str
    node_name: str

class WriteSplitEvent(Message):
    """rosbag2_interfaces/msg/WriteSplitEvent

    # Says that a recorder has finished a file of a bag and begun the next one.

    # Path of the finished file.
    string closed_file

    # Path of the new file.
    string opened_file

    # Full name of the recorder's node.
    string node_name
    """
    def __init__(self, *, closed_file: str = ..., opened_file: str = ..., node_name: str = ..., check_fields: bool = ...) -> None: ...
    closed_file: str
    opened_file: str
    node_name: str
