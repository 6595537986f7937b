# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
import rosbridge_msgs.msg
from zbot.interfaces import Action, Message, Service

class ConnectedClient(Message):
    """rosbridge_msgs/msg/ConnectedClient

    # A program that is connected to rosbridge.

    string ip_address
    builtin_interfaces/Time connection_time
    """
    def __init__(self, *, ip_address: str = ..., connection_time: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    ip_address: str
    connection_time: builtin_interfaces.msg.Time

class ConnectedClients(Message):
    """rosbridge_msgs/msg/ConnectedClients

    # The programs that are connected to rosbridge.

    ConnectedClient[] clients
    """
    def __init__(self, *, clients: Collection[rosbridge_msgs.msg.ConnectedClient] = ..., check_fields: bool = ...) -> None: ...
    @property
    def clients(self) -> list[rosbridge_msgs.msg.ConnectedClient]: ...
    @clients.setter
    def clients(self, value: Collection[rosbridge_msgs.msg.ConnectedClient]) -> None: ...
