# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
from zbot.interfaces import Action, Message, Service

class ServiceEventInfo(Message):
    """service_msgs/msg/ServiceEventInfo

    # Which step of which service call an introspection event reports.

    uint8 REQUEST_SENT = 0
    uint8 REQUEST_RECEIVED = 1
    uint8 RESPONSE_SENT = 2
    uint8 RESPONSE_RECEIVED = 3

    # One of the steps above.
    uint8 event_type

    # When the step happened.
    builtin_interfaces/Time stamp

    # Identity of the calling client, valid while it runs.
    char[16] client_gid

    # Number the client gave to the call; together with client_gid it names one call.
    int64 sequence_number
    """
    REQUEST_SENT: Final = 0
    REQUEST_RECEIVED: Final = 1
    RESPONSE_SENT: Final = 2
    RESPONSE_RECEIVED: Final = 3
    def __init__(self, *, event_type: int = ..., stamp: builtin_interfaces.msg.Time = ..., client_gid: Collection[int] = ..., sequence_number: int = ..., check_fields: bool = ...) -> None: ...
    event_type: int
    stamp: builtin_interfaces.msg.Time
    @property
    def client_gid(self) -> NDArray[numpy.uint8]: ...
    @client_gid.setter
    def client_gid(self, value: Collection[int]) -> None: ...
    sequence_number: int
