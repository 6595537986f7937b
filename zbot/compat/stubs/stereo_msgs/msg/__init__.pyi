# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import sensor_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class DisparityImage(Message):
    """stereo_msgs/msg/DisparityImage

    # How far each pixel of a stereo camera's left image is shifted in the right one; near things shift most.

    # Time and frame, the same as in image.
    std_msgs/Header header

    # The shifts in pixels, as 32-bit decimal numbers; the offset between the two image centres is taken out.
    sensor_msgs/Image image

    # Depth of a pixel with shift d: Z = f * t / d.
    float32 f # focal length in pixels
    float32 t # distance between the lenses, in m

    # The part of the image that can hold results.
    sensor_msgs/RegionOfInterest valid_window

    # Shifts searched for; a smaller value in the image marks a pixel without result.
    # They bound the depth that can be seen: from f * t / max_disparity to f * t / min_disparity.
    float32 min_disparity
    float32 max_disparity

    # Finest step between shifts; at depth Z it makes a depth step of Z^2 / (f * t) * delta_d.
    float32 delta_d
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., image: sensor_msgs.msg.Image = ..., f: float = ..., t: float = ..., valid_window: sensor_msgs.msg.RegionOfInterest = ..., min_disparity: float = ..., max_disparity: float = ..., delta_d: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    image: sensor_msgs.msg.Image
    f: float
    t: float
    valid_window: sensor_msgs.msg.RegionOfInterest
    min_disparity: float
    max_disparity: float
    delta_d: float
