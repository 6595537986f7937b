# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

from zbot.interfaces import Action, Message, Service

class UUID(Message):
    """unique_identifier_msgs/msg/UUID

    # A universally unique identifier (RFC 4122): 16 bytes that nobody else will pick.

    uint8[16] uuid
    """
    def __init__(self, *, uuid: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    @property
    def uuid(self) -> NDArray[numpy.uint8]: ...
    @uuid.setter
    def uuid(self, value: Collection[int]) -> None: ...
