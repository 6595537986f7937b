# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

from zbot.interfaces import Action, Message, Service

class TypeDef(Message):
    """rosapi_msgs/msg/TypeDef

    # The fields and constants of a type.

    string type
    string[] fieldnames
    string[] fieldtypes
    int32[] fieldarraylen  # -1: no array, 0: any length
    string[] examples  # default values of the fields
    string[] constnames
    string[] constvalues
    """
    def __init__(self, *, type: str = ..., fieldnames: Collection[str] = ..., fieldtypes: Collection[str] = ..., fieldarraylen: Collection[int] = ..., examples: Collection[str] = ..., constnames: Collection[str] = ..., constvalues: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    type: str
    @property
    def fieldnames(self) -> list[str]: ...
    @fieldnames.setter
    def fieldnames(self, value: Collection[str]) -> None: ...
    @property
    def fieldtypes(self) -> list[str]: ...
    @fieldtypes.setter
    def fieldtypes(self, value: Collection[str]) -> None: ...
    @property
    def fieldarraylen(self) -> array[int]: ...
    @fieldarraylen.setter
    def fieldarraylen(self, value: Collection[int]) -> None: ...
    @property
    def examples(self) -> list[str]: ...
    @examples.setter
    def examples(self, value: Collection[str]) -> None: ...
    @property
    def constnames(self) -> list[str]: ...
    @constnames.setter
    def constnames(self, value: Collection[str]) -> None: ...
    @property
    def constvalues(self) -> list[str]: ...
    @constvalues.setter
    def constvalues(self, value: Collection[str]) -> None: ...
