# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
from zbot.interfaces import Action, Message, Service

class Clock(Message):
    """rosgraph_msgs/msg/Clock

    # The current simulated time, sent on /clock to nodes that run with use_sim_time.

    builtin_interfaces/Time clock
    """
    def __init__(self, *, clock: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    clock: builtin_interfaces.msg.Time
