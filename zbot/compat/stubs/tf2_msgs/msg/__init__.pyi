# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import geometry_msgs.msg
from zbot.interfaces import Action, Message, Service

class TF2Error(Message):
    """tf2_msgs/msg/TF2Error

    # Why a transform could not be found.

    uint8 NO_ERROR = 0
    uint8 LOOKUP_ERROR = 1           # no such frame
    uint8 CONNECTIVITY_ERROR = 2     # the two frames are not in one tree
    uint8 EXTRAPOLATION_ERROR = 3    # known, but not for that time
    uint8 INVALID_ARGUMENT_ERROR = 4 # the question makes no sense
    uint8 TIMEOUT_ERROR = 5          # not known in time
    uint8 TRANSFORM_ERROR = 6        # any other reason

    uint8 error # one of the codes above
    string error_string # details for people
    """
    NO_ERROR: Final = 0
    LOOKUP_ERROR: Final = 1
    CONNECTIVITY_ERROR: Final = 2
    EXTRAPOLATION_ERROR: Final = 3
    INVALID_ARGUMENT_ERROR: Final = 4
    TIMEOUT_ERROR: Final = 5
    TRANSFORM_ERROR: Final = 6
    def __init__(self, *, error: int = ..., error_string: str = ..., check_fields: bool = ...) -> None: ...
    error: int
    error_string: str

class TFMessage(Message):
    """tf2_msgs/msg/TFMessage

    # Places of coordinate frames, as sent on /tf (moving) and /tf_static (fixed).

    geometry_msgs/TransformStamped[] transforms
    """
    def __init__(self, *, transforms: Collection[geometry_msgs.msg.TransformStamped] = ..., check_fields: bool = ...) -> None: ...
    @property
    def transforms(self) -> list[geometry_msgs.msg.TransformStamped]: ...
    @transforms.setter
    def transforms(self, value: Collection[geometry_msgs.msg.TransformStamped]) -> None: ...
