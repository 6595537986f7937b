# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
import test_msgs.msg
from zbot.interfaces import Action, Message, Service

class Arrays(Message):
    """test_msgs/msg/Arrays

    # Arrays of three of every type, without and with defaults.

    bool[3] bool_values
    byte[3] byte_values
    char[3] char_values
    float32[3] float32_values
    float64[3] float64_values
    int8[3] int8_values
    uint8[3] uint8_values
    int16[3] int16_values
    uint16[3] uint16_values
    int32[3] int32_values
    uint32[3] uint32_values
    int64[3] int64_values
    uint64[3] uint64_values
    string[3] string_values
    BasicTypes[3] basic_types_values
    Constants[3] constants_values
    Defaults[3] defaults_values
    bool[3] bool_values_default [false, true, false]
    byte[3] byte_values_default [0, 1, 255]
    char[3] char_values_default [0, 1, 127]
    float32[3] float32_values_default [1.125, 0.0, -1.125]
    float64[3] float64_values_default [3.1415, 0.0, -3.1415]
    int8[3] int8_values_default [0, 127, -128]
    uint8[3] uint8_values_default [0, 1, 255]
    int16[3] int16_values_default [0, 32767, -32768]
    uint16[3] uint16_values_default [0, 1, 65535]
    int32[3] int32_values_default [0, 2147483647, -2147483648]
    uint32[3] uint32_values_default [0, 1, 4294967295]
    int64[3] int64_values_default [0, 9223372036854775807, -9223372036854775808]
    uint64[3] uint64_values_default [0, 1, 18446744073709551615]
    string[3] string_values_default ["", "max value", "min value"]
    int32 alignment_check
    """
    def __init__(self, *, bool_values: Collection[bool] = ..., byte_values: Collection[bytes] = ..., char_values: Collection[int] = ..., float32_values: Collection[float] = ..., float64_values: Collection[float] = ..., int8_values: Collection[int] = ..., uint8_values: Collection[int] = ..., int16_values: Collection[int] = ..., uint16_values: Collection[int] = ..., int32_values: Collection[int] = ..., uint32_values: Collection[int] = ..., int64_values: Collection[int] = ..., uint64_values: Collection[int] = ..., string_values: Collection[str] = ..., basic_types_values: Collection[test_msgs.msg.BasicTypes] = ..., constants_values: Collection[test_msgs.msg.Constants] = ..., defaults_values: Collection[test_msgs.msg.Defaults] = ..., bool_values_default: Collection[bool] = ..., byte_values_default: Collection[bytes] = ..., char_values_default: Collection[int] = ..., float32_values_default: Collection[float] = ..., float64_values_default: Collection[float] = ..., int8_values_default: Collection[int] = ..., uint8_values_default: Collection[int] = ..., int16_values_default: Collection[int] = ..., uint16_values_default: Collection[int] = ..., int32_values_default: Collection[int] = ..., uint32_values_default: Collection[int] = ..., int64_values_default: Collection[int] = ..., uint64_values_default: Collection[int] = ..., string_values_default: Collection[str] = ..., alignment_check: int = ..., check_fields: bool = ...) -> None: ...
    @property
    def bool_values(self) -> list[bool]: ...
    @bool_values.setter
    def bool_values(self, value: Collection[bool]) -> None: ...
    @property
    def byte_values(self) -> list[bytes]: ...
    @byte_values.setter
    def byte_values(self, value: Collection[bytes]) -> None: ...
    @property
    def char_values(self) -> NDArray[numpy.uint8]: ...
    @char_values.setter
    def char_values(self, value: Collection[int]) -> None: ...
    @property
    def float32_values(self) -> NDArray[numpy.float32]: ...
    @float32_values.setter
    def float32_values(self, value: Collection[float]) -> None: ...
    @property
    def float64_values(self) -> NDArray[numpy.float64]: ...
    @float64_values.setter
    def float64_values(self, value: Collection[float]) -> None: ...
    @property
    def int8_values(self) -> NDArray[numpy.int8]: ...
    @int8_values.setter
    def int8_values(self, value: Collection[int]) -> None: ...
    @property
    def uint8_values(self) -> NDArray[numpy.uint8]: ...
    @uint8_values.setter
    def uint8_values(self, value: Collection[int]) -> None: ...
    @property
    def int16_values(self) -> NDArray[numpy.int16]: ...
    @int16_values.setter
    def int16_values(self, value: Collection[int]) -> None: ...
    @property
    def uint16_values(self) -> NDArray[numpy.uint16]: ...
    @uint16_values.setter
    def uint16_values(self, value: Collection[int]) -> None: ...
    @property
    def int32_values(self) -> NDArray[numpy.int32]: ...
    @int32_values.setter
    def int32_values(self, value: Collection[int]) -> None: ...
    @property
    def uint32_values(self) -> NDArray[numpy.uint32]: ...
    @uint32_values.setter
    def uint32_values(self, value: Collection[int]) -> None: ...
    @property
    def int64_values(self) -> NDArray[numpy.int64]: ...
    @int64_values.setter
    def int64_values(self, value: Collection[int]) -> None: ...
    @property
    def uint64_values(self) -> NDArray[numpy.uint64]: ...
    @uint64_values.setter
    def uint64_values(self, value: Collection[int]) -> None: ...
    @property
    def string_values(self) -> list[str]: ...
    @string_values.setter
    def string_values(self, value: Collection[str]) -> None: ...
    @property
    def basic_types_values(self) -> list[test_msgs.msg.BasicTypes]: ...
    @basic_types_values.setter
    def basic_types_values(self, value: Collection[test_msgs.msg.BasicTypes]) -> None: ...
    @property
    def constants_values(self) -> list[test_msgs.msg.Constants]: ...
    @constants_values.setter
    def constants_values(self, value: Collection[test_msgs.msg.Constants]) -> None: ...
    @property
    def defaults_values(self) -> list[test_msgs.msg.Defaults]: ...
    @defaults_values.setter
    def defaults_values(self, value: Collection[test_msgs.msg.Defaults]) -> None: ...
    @property
    def bool_values_default(self) -> list[bool]: ...
    @bool_values_default.setter
    def bool_values_default(self, value: Collection[bool]) -> None: ...
    @property
    def byte_values_default(self) -> list[bytes]: ...
    @byte_values_default.setter
    def byte_values_default(self, value: Collection[bytes]) -> None: ...
    @property
    def char_values_default(self) -> NDArray[numpy.uint8]: ...
    @char_values_default.setter
    def char_values_default(self, value: Collection[int]) -> None: ...
    @property
    def float32_values_default(self) -> NDArray[numpy.float32]: ...
    @float32_values_default.setter
    def float32_values_default(self, value: Collection[float]) -> None: ...
    @property
    def float64_values_default(self) -> NDArray[numpy.float64]: ...
    @float64_values_default.setter
    def float64_values_default(self, value: Collection[float]) -> None: ...
    @property
    def int8_values_default(self) -> NDArray[numpy.int8]: ...
    @int8_values_default.setter
    def int8_values_default(self, value: Collection[int]) -> None: ...
    @property
    def uint8_values_default(self) -> NDArray[numpy.uint8]: ...
    @uint8_values_default.setter
    def uint8_values_default(self, value: Collection[int]) -> None: ...
    @property
    def int16_values_default(self) -> NDArray[numpy.int16]: ...
    @int16_values_default.setter
    def int16_values_default(self, value: Collection[int]) -> None: ...
    @property
    def uint16_values_default(self) -> NDArray[numpy.uint16]: ...
    @uint16_values_default.setter
    def uint16_values_default(self, value: Collection[int]) -> None: ...
    @property
    def int32_values_default(self) -> NDArray[numpy.int32]: ...
    @int32_values_default.setter
    def int32_values_default(self, value: Collection[int]) -> None: ...
    @property
    def uint32_values_default(self) -> NDArray[numpy.uint32]: ...
    @uint32_values_default.setter
    def uint32_values_default(self, value: Collection[int]) -> None: ...
    @property
    def int64_values_default(self) -> NDArray[numpy.int64]: ...
    @int64_values_default.setter
    def int64_values_default(self, value: Collection[int]) -> None: ...
    @property
    def uint64_values_default(self) -> NDArray[numpy.uint64]: ...
    @uint64_values_default.setter
    def uint64_values_default(self, value: Collection[int]) -> None: ...
    @property
    def string_values_default(self) -> list[str]: ...
    @string_values_default.setter
    def string_values_default(self, value: Collection[str]) -> None: ...
    alignment_check: int

class BasicTypes(Message):
    """test_msgs/msg/BasicTypes

    # One field of every primitive type.

    bool bool_value
    byte byte_value
    char char_value
    float32 float32_value
    float64 float64_value
    int8 int8_value
    uint8 uint8_value
    int16 int16_value
    uint16 uint16_value
    int32 int32_value
    uint32 uint32_value
    int64 int64_value
    uint64 uint64_value
    """
    def __init__(self, *, bool_value: bool = ..., byte_value: bytes = ..., char_value: int = ..., float32_value: float = ..., float64_value: float = ..., int8_value: int = ..., uint8_value: int = ..., int16_value: int = ..., uint16_value: int = ..., int32_value: int = ..., uint32_value: int = ..., int64_value: int = ..., uint64_value: int = ..., check_fields: bool = ...) -> None: ...
    bool_value: bool
    byte_value: bytes
    char_value: int
    float32_value: float
    float64_value: float
    int8_value: int
    uint8_value: int
    int16_value: int
    uint16_value: int
    int32_value: int
    uint32_value: int
    int64_value: int
    uint64_value: int

class BoundedPlainSequences(Message):
    """test_msgs/msg/BoundedPlainSequences

    # Sequences of at most three of every type without a length of its own.

    bool[<=3] bool_values
    byte[<=3] byte_values
    char[<=3] char_values
    float32[<=3] float32_values
    float64[<=3] float64_values
    int8[<=3] int8_values
    uint8[<=3] uint8_values
    int16[<=3] int16_values
    uint16[<=3] uint16_values
    int32[<=3] int32_values
    uint32[<=3] uint32_values
    int64[<=3] int64_values
    uint64[<=3] uint64_values
    BasicTypes[<=3] basic_types_values
    Constants[<=3] constants_values
    Defaults[<=3] defaults_values
    bool[<=3] bool_values_default [false, true, false]
    byte[<=3] byte_values_default [0, 1, 255]
    char[<=3] char_values_default [0, 1, 127]
    float32[<=3] float32_values_default [1.125, 0.0, -1.125]
    float64[<=3] float64_values_default [3.1415, 0.0, -3.1415]
    int8[<=3] int8_values_default [0, 127, -128]
    uint8[<=3] uint8_values_default [0, 1, 255]
    int16[<=3] int16_values_default [0, 32767, -32768]
    uint16[<=3] uint16_values_default [0, 1, 65535]
    int32[<=3] int32_values_default [0, 2147483647, -2147483648]
    uint32[<=3] uint32_values_default [0, 1, 4294967295]
    int64[<=3] int64_values_default [0, 9223372036854775807, -9223372036854775808]
    uint64[<=3] uint64_values_default [0, 1, 18446744073709551615]
    int32 alignment_check
    """
    def __init__(self, *, bool_values: Collection[bool] = ..., byte_values: Collection[bytes] = ..., char_values: Collection[int] = ..., float32_values: Collection[float] = ..., float64_values: Collection[float] = ..., int8_values: Collection[int] = ..., uint8_values: Collection[int] = ..., int16_values: Collection[int] = ..., uint16_values: Collection[int] = ..., int32_values: Collection[int] = ..., uint32_values: Collection[int] = ..., int64_values: Collection[int] = ..., uint64_values: Collection[int] = ..., basic_types_values: Collection[test_msgs.msg.BasicTypes] = ..., constants_values: Collection[test_msgs.msg.Constants] = ..., defaults_values: Collection[test_msgs.msg.Defaults] = ..., bool_values_default: Collection[bool] = ..., byte_values_default: Collection[bytes] = ..., char_values_default: Collection[int] = ..., float32_values_default: Collection[float] = ..., float64_values_default: Collection[float] = ..., int8_values_default: Collection[int] = ..., uint8_values_default: Collection[int] = ..., int16_values_default: Collection[int] = ..., uint16_values_default: Collection[int] = ..., int32_values_default: Collection[int] = ..., uint32_values_default: Collection[int] = ..., int64_values_default: Collection[int] = ..., uint64_values_default: Collection[int] = ..., alignment_check: int = ..., check_fields: bool = ...) -> None: ...
    @property
    def bool_values(self) -> list[bool]: ...
    @bool_values.setter
    def bool_values(self, value: Collection[bool]) -> None: ...
    @property
    def byte_values(self) -> list[bytes]: ...
    @byte_values.setter
    def byte_values(self, value: Collection[bytes]) -> None: ...
    @property
    def char_values(self) -> array[int]: ...
    @char_values.setter
    def char_values(self, value: Collection[int]) -> None: ...
    @property
    def float32_values(self) -> array[float]: ...
    @float32_values.setter
    def float32_values(self, value: Collection[float]) -> None: ...
    @property
    def float64_values(self) -> array[float]: ...
    @float64_values.setter
    def float64_values(self, value: Collection[float]) -> None: ...
    @property
    def int8_values(self) -> array[int]: ...
    @int8_values.setter
    def int8_values(self, value: Collection[int]) -> None: ...
    @property
    def uint8_values(self) -> array[int]: ...
    @uint8_values.setter
    def uint8_values(self, value: Collection[int]) -> None: ...
    @property
    def int16_values(self) -> array[int]: ...
    @int16_values.setter
    def int16_values(self, value: Collection[int]) -> None: ...
    @property
    def uint16_values(self) -> array[int]: ...
    @uint16_values.setter
    def uint16_values(self, value: Collection[int]) -> None: ...
    @property
    def int32_values(self) -> array[int]: ...
    @int32_values.setter
    def int32_values(self, value: Collection[int]) -> None: ...
    @property
    def uint32_values(self) -> array[int]: ...
    @uint32_values.setter
    def uint32_values(self, value: Collection[int]) -> None: ...
    @property
    def int64_values(self) -> array[int]: ...
    @int64_values.setter
    def int64_values(self, value: Collection[int]) -> None: ...
    @property
    def uint64_values(self) -> array[int]: ...
    @uint64_values.setter
    def uint64_values(self, value: Collection[int]) -> None: ...
    @property
    def basic_types_values(self) -> list[test_msgs.msg.BasicTypes]: ...
    @basic_types_values.setter
    def basic_types_values(self, value: Collection[test_msgs.msg.BasicTypes]) -> None: ...
    @property
    def constants_values(self) -> list[test_msgs.msg.Constants]: ...
    @constants_values.setter
    def constants_values(self, value: Collection[test_msgs.msg.Constants]) -> None: ...
    @property
    def defaults_values(self) -> list[test_msgs.msg.Defaults]: ...
    @defaults_values.setter
    def defaults_values(self, value: Collection[test_msgs.msg.Defaults]) -> None: ...
    @property
    def bool_values_default(self) -> list[bool]: ...
    @bool_values_default.setter
    def bool_values_default(self, value: Collection[bool]) -> None: ...
    @property
    def byte_values_default(self) -> list[bytes]: ...
    @byte_values_default.setter
    def byte_values_default(self, value: Collection[bytes]) -> None: ...
    @property
    def char_values_default(self) -> array[int]: ...
    @char_values_default.setter
    def char_values_default(self, value: Collection[int]) -> None: ...
    @property
    def float32_values_default(self) -> array[float]: ...
    @float32_values_default.setter
    def float32_values_default(self, value: Collection[float]) -> None: ...
    @property
    def float64_values_default(self) -> array[float]: ...
    @float64_values_default.setter
    def float64_values_default(self, value: Collection[float]) -> None: ...
    @property
    def int8_values_default(self) -> array[int]: ...
    @int8_values_default.setter
    def int8_values_default(self, value: Collection[int]) -> None: ...
    @property
    def uint8_values_default(self) -> array[int]: ...
    @uint8_values_default.setter
    def uint8_values_default(self, value: Collection[int]) -> None: ...
    @property
    def int16_values_default(self) -> array[int]: ...
    @int16_values_default.setter
    def int16_values_default(self, value: Collection[int]) -> None: ...
    @property
    def uint16_values_default(self) -> array[int]: ...
    @uint16_values_default.setter
    def uint16_values_default(self, value: Collection[int]) -> None: ...
    @property
    def int32_values_default(self) -> array[int]: ...
    @int32_values_default.setter
    def int32_values_default(self, value: Collection[int]) -> None: ...
    @property
    def uint32_values_default(self) -> array[int]: ...
    @uint32_values_default.setter
    def uint32_values_default(self, value: Collection[int]) -> None: ...
    @property
    def int64_values_default(self) -> array[int]: ...
    @int64_values_default.setter
    def int64_values_default(self, value: Collection[int]) -> None: ...
    @property
    def uint64_values_default(self) -> array[int]: ...
    @uint64_values_default.setter
    def uint64_values_default(self, value: Collection[int]) -> None: ...
    alignment_check: int

class BoundedSequences(Message):
    """test_msgs/msg/BoundedSequences

    # Sequences of at most three of every type.

    bool[<=3] bool_values
    byte[<=3] byte_values
    char[<=3] char_values
    float32[<=3] float32_values
    float64[<=3] float64_values
    int8[<=3] int8_values
    uint8[<=3] uint8_values
    int16[<=3] int16_values
    uint16[<=3] uint16_values
    int32[<=3] int32_values
    uint32[<=3] uint32_values
    int64[<=3] int64_values
    uint64[<=3] uint64_values
    string[<=3] string_values
    BasicTypes[<=3] basic_types_values
    Constants[<=3] constants_values
    Defaults[<=3] defaults_values
    bool[<=3] bool_values_default [false, true, false]
    byte[<=3] byte_values_default [0, 1, 255]
    char[<=3] char_values_default [0, 1, 127]
    float32[<=3] float32_values_default [1.125, 0.0, -1.125]
    float64[<=3] float64_values_default [3.1415, 0.0, -3.1415]
    int8[<=3] int8_values_default [0, 127, -128]
    uint8[<=3] uint8_values_default [0, 1, 255]
    int16[<=3] int16_values_default [0, 32767, -32768]
    uint16[<=3] uint16_values_default [0, 1, 65535]
    int32[<=3] int32_values_default [0, 2147483647, -2147483648]
    uint32[<=3] uint32_values_default [0, 1, 4294967295]
    int64[<=3] int64_values_default [0, 9223372036854775807, -9223372036854775808]
    uint64[<=3] uint64_values_default [0, 1, 18446744073709551615]
    string[<=3] string_values_default ["", "max value", "min value"]
    int32 alignment_check
    """
    def __init__(self, *, bool_values: Collection[bool] = ..., byte_values: Collection[bytes] = ..., char_values: Collection[int] = ..., float32_values: Collection[float] = ..., float64_values: Collection[float] = ..., int8_values: Collection[int] = ..., uint8_values: Collection[int] = ..., int16_values: Collection[int] = ..., uint16_values: Collection[int] = ..., int32_values: Collection[int] = ..., uint32_values: Collection[int] = ..., int64_values: Collection[int] = ..., uint64_values: Collection[int] = ..., string_values: Collection[str] = ..., basic_types_values: Collection[test_msgs.msg.BasicTypes] = ..., constants_values: Collection[test_msgs.msg.Constants] = ..., defaults_values: Collection[test_msgs.msg.Defaults] = ..., bool_values_default: Collection[bool] = ..., byte_values_default: Collection[bytes] = ..., char_values_default: Collection[int] = ..., float32_values_default: Collection[float] = ..., float64_values_default: Collection[float] = ..., int8_values_default: Collection[int] = ..., uint8_values_default: Collection[int] = ..., int16_values_default: Collection[int] = ..., uint16_values_default: Collection[int] = ..., int32_values_default: Collection[int] = ..., uint32_values_default: Collection[int] = ..., int64_values_default: Collection[int] = ..., uint64_values_default: Collection[int] = ..., string_values_default: Collection[str] = ..., alignment_check: int = ..., check_fields: bool = ...) -> None: ...
    @property
    def bool_values(self) -> list[bool]: ...
    @bool_values.setter
    def bool_values(self, value: Collection[bool]) -> None: ...
    @property
    def byte_values(self) -> list[bytes]: ...
    @byte_values.setter
    def byte_values(self, value: Collection[bytes]) -> None: ...
    @property
    def char_values(self) -> array[int]: ...
    @char_values.setter
    def char_values(self, value: Collection[int]) -> None: ...
    @property
    def float32_values(self) -> array[float]: ...
    @float32_values.setter
    def float32_values(self, value: Collection[float]) -> None: ...
    @property
    def float64_values(self) -> array[float]: ...
    @float64_values.setter
    def float64_values(self, value: Collection[float]) -> None: ...
    @property
    def int8_values(self) -> array[int]: ...
    @int8_values.setter
    def int8_values(self, value: Collection[int]) -> None: ...
    @property
    def uint8_values(self) -> array[int]: ...
    @uint8_values.setter
    def uint8_values(self, value: Collection[int]) -> None: ...
    @property
    def int16_values(self) -> array[int]: ...
    @int16_values.setter
    def int16_values(self, value: Collection[int]) -> None: ...
    @property
    def uint16_values(self) -> array[int]: ...
    @uint16_values.setter
    def uint16_values(self, value: Collection[int]) -> None: ...
    @property
    def int32_values(self) -> array[int]: ...
    @int32_values.setter
    def int32_values(self, value: Collection[int]) -> None: ...
    @property
    def uint32_values(self) -> array[int]: ...
    @uint32_values.setter
    def uint32_values(self, value: Collection[int]) -> None: ...
    @property
    def int64_values(self) -> array[int]: ...
    @int64_values.setter
    def int64_values(self, value: Collection[int]) -> None: ...
    @property
    def uint64_values(self) -> array[int]: ...
    @uint64_values.setter
    def uint64_values(self, value: Collection[int]) -> None: ...
    @property
    def string_values(self) -> list[str]: ...
    @string_values.setter
    def string_values(self, value: Collection[str]) -> None: ...
    @property
    def basic_types_values(self) -> list[test_msgs.msg.BasicTypes]: ...
    @basic_types_values.setter
    def basic_types_values(self, value: Collection[test_msgs.msg.BasicTypes]) -> None: ...
    @property
    def constants_values(self) -> list[test_msgs.msg.Constants]: ...
    @constants_values.setter
    def constants_values(self, value: Collection[test_msgs.msg.Constants]) -> None: ...
    @property
    def defaults_values(self) -> list[test_msgs.msg.Defaults]: ...
    @defaults_values.setter
    def defaults_values(self, value: Collection[test_msgs.msg.Defaults]) -> None: ...
    @property
    def bool_values_default(self) -> list[bool]: ...
    @bool_values_default.setter
    def bool_values_default(self, value: Collection[bool]) -> None: ...
    @property
    def byte_values_default(self) -> list[bytes]: ...
    @byte_values_default.setter
    def byte_values_default(self, value: Collection[bytes]) -> None: ...
    @property
    def char_values_default(self) -> array[int]: ...
    @char_values_default.setter
    def char_values_default(self, value: Collection[int]) -> None: ...
    @property
    def float32_values_default(self) -> array[float]: ...
    @float32_values_default.setter
    def float32_values_default(self, value: Collection[float]) -> None: ...
    @property
    def float64_values_default(self) -> array[float]: ...
    @float64_values_default.setter
    def float64_values_default(self, value: Collection[float]) -> None: ...
    @property
    def int8_values_default(self) -> array[int]: ...
    @int8_values_default.setter
    def int8_values_default(self, value: Collection[int]) -> None: ...
    @property
    def uint8_values_default(self) -> array[int]: ...
    @uint8_values_default.setter
    def uint8_values_default(self, value: Collection[int]) -> None: ...
    @property
    def int16_values_default(self) -> array[int]: ...
    @int16_values_default.setter
    def int16_values_default(self, value: Collection[int]) -> None: ...
    @property
    def uint16_values_default(self) -> array[int]: ...
    @uint16_values_default.setter
    def uint16_values_default(self, value: Collection[int]) -> None: ...
    @property
    def int32_values_default(self) -> array[int]: ...
    @int32_values_default.setter
    def int32_values_default(self, value: Collection[int]) -> None: ...
    @property
    def uint32_values_default(self) -> array[int]: ...
    @uint32_values_default.setter
    def uint32_values_default(self, value: Collection[int]) -> None: ...
    @property
    def int64_values_default(self) -> array[int]: ...
    @int64_values_default.setter
    def int64_values_default(self, value: Collection[int]) -> None: ...
    @property
    def uint64_values_default(self) -> array[int]: ...
    @uint64_values_default.setter
    def uint64_values_default(self, value: Collection[int]) -> None: ...
    @property
    def string_values_default(self) -> list[str]: ...
    @string_values_default.setter
    def string_values_default(self, value: Collection[str]) -> None: ...
    alignment_check: int

class Builtins(Message):
    """test_msgs/msg/Builtins

    # The two messages that every other package builds on.

    builtin_interfaces/Duration duration_value
    builtin_interfaces/Time time_value
    """
    def __init__(self, *, duration_value: builtin_interfaces.msg.Duration = ..., time_value: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    duration_value: builtin_interfaces.msg.Duration
    time_value: builtin_interfaces.msg.Time

class ComplexNestedKey(Message):
    """test_msgs/msg/ComplexNestedKey

    # Keys two levels deep.

    uint32 uint32_key
    NonKeyedWithNestedKey nested_keys
    float64 float64_value
    """
    def __init__(self, *, uint32_key: int = ..., nested_keys: test_msgs.msg.NonKeyedWithNestedKey = ..., float64_value: float = ..., check_fields: bool = ...) -> None: ...
    uint32_key: int
    nested_keys: test_msgs.msg.NonKeyedWithNestedKey
    float64_value: float

class Constants(Message):
    """test_msgs/msg/Constants

    # A constant of every primitive type, and no field.

    bool BOOL_CONST=true
    byte BYTE_CONST=50
    char CHAR_CONST=100
    float32 FLOAT32_CONST=1.125
    float64 FLOAT64_CONST=1.125
    int8 INT8_CONST=-50
    uint8 UINT8_CONST=200
    int16 INT16_CONST=-1000
    uint16 UINT16_CONST=2000
    int32 INT32_CONST=-30000
    uint32 UINT32_CONST=60000
    int64 INT64_CONST=-40000000
    uint64 UINT64_CONST=50000000
    """
    BOOL_CONST: Final = True
    BYTE_CONST: Final = b'2'
    CHAR_CONST: Final = 100
    FLOAT32_CONST: Final = 1.125
    FLOAT64_CONST: Final = 1.125
    INT8_CONST: Final = -50
    UINT8_CONST: Final = 200
    INT16_CONST: Final = -1000
    UINT16_CONST: Final = 2000
    INT32_CONST: Final = -30000
    UINT32_CONST: Final = 60000
    INT64_CONST: Final = -40000000
    UINT64_CONST: Final = 50000000
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Defaults(Message):
    """test_msgs/msg/Defaults

    # A field with a default of every primitive type.

    bool bool_value true
    byte byte_value 50
    char char_value 100
    float32 float32_value 1.125
    float64 float64_value 1.125
    int8 int8_value -50
    uint8 uint8_value 200
    int16 int16_value -1000
    uint16 uint16_value 2000
    int32 int32_value -30000
    uint32 uint32_value 60000
    int64 int64_value -40000000
    uint64 uint64_value 50000000
    """
    def __init__(self, *, bool_value: bool = ..., byte_value: bytes = ..., char_value: int = ..., float32_value: float = ..., float64_value: float = ..., int8_value: int = ..., uint8_value: int = ..., int16_value: int = ..., uint16_value: int = ..., int32_value: int = ..., uint32_value: int = ..., int64_value: int = ..., uint64_value: int = ..., check_fields: bool = ...) -> None: ...
    bool_value: bool
    byte_value: bytes
    char_value: int
    float32_value: float
    float64_value: float
    int8_value: int
    uint8_value: int
    int16_value: int
    uint16_value: int
    int32_value: int
    uint32_value: int
    int64_value: int
    uint64_value: int

class Empty(Message):
    """test_msgs/msg/Empty

    # Nothing at all: the emptiest there can be.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class KeyedLong(Message):
    """test_msgs/msg/KeyedLong

    # A value under a key, which other middlewares tell instances by.

    int32 key
    int32 value
    """
    def __init__(self, *, key: int = ..., value: int = ..., check_fields: bool = ...) -> None: ...
    key: int
    value: int

class KeyedString(Message):
    """test_msgs/msg/KeyedString

    # A value under a key, which other middlewares tell instances by.

    string key
    string value
    """
    def __init__(self, *, key: str = ..., value: str = ..., check_fields: bool = ...) -> None: ...
    key: str
    value: str

class MultiNested(Message):
    """test_msgs/msg/MultiNested

    # Arrays and sequences of messages that hold arrays and sequences themselves.

    Arrays[3] array_of_arrays
    BoundedSequences[3] array_of_bounded_sequences
    UnboundedSequences[3] array_of_unbounded_sequences
    Arrays[<=3] bounded_sequence_of_arrays
    BoundedSequences[<=3] bounded_sequence_of_bounded_sequences
    UnboundedSequences[<=3] bounded_sequence_of_unbounded_sequences
    Arrays[] unbounded_sequence_of_arrays
    BoundedSequences[] unbounded_sequence_of_bounded_sequences
    UnboundedSequences[] unbounded_sequence_of_unbounded_sequences
    """
    def __init__(self, *, array_of_arrays: Collection[test_msgs.msg.Arrays] = ..., array_of_bounded_sequences: Collection[test_msgs.msg.BoundedSequences] = ..., array_of_unbounded_sequences: Collection[test_msgs.msg.UnboundedSequences] = ..., bounded_sequence_of_arrays: Collection[test_msgs.msg.Arrays] = ..., bounded_sequence_of_bounded_sequences: Collection[test_msgs.msg.BoundedSequences] = ..., bounded_sequence_of_unbounded_sequences: Collection[test_msgs.msg.UnboundedSequences] = ..., unbounded_sequence_of_arrays: Collection[test_msgs.msg.Arrays] = ..., unbounded_sequence_of_bounded_sequences: Collection[test_msgs.msg.BoundedSequences] = ..., unbounded_sequence_of_unbounded_sequences: Collection[test_msgs.msg.UnboundedSequences] = ..., check_fields: bool = ...) -> None: ...
    @property
    def array_of_arrays(self) -> list[test_msgs.msg.Arrays]: ...
    @array_of_arrays.setter
    def array_of_arrays(self, value: Collection[test_msgs.msg.Arrays]) -> None: ...
    @property
    def array_of_bounded_sequences(self) -> list[test_msgs.msg.BoundedSequences]: ...
    @array_of_bounded_sequences.setter
    def array_of_bounded_sequences(self, value: Collection[test_msgs.msg.BoundedSequences]) -> None: ...
    @property
    def array_of_unbounded_sequences(self) -> list[test_msgs.msg.UnboundedSequences]: ...
    @array_of_unbounded_sequences.setter
    def array_of_unbounded_sequences(self, value: Collection[test_msgs.msg.UnboundedSequences]) -> None: ...
    @property
    def bounded_sequence_of_arrays(self) -> list[test_msgs.msg.Arrays]: ...
    @bounded_sequence_of_arrays.setter
    def bounded_sequence_of_arrays(self, value: Collection[test_msgs.msg.Arrays]) -> None: ...
    @property
    def bounded_sequence_of_bounded_sequences(self) -> list[test_msgs.msg.BoundedSequences]: ...
    @bounded_sequence_of_bounded_sequences.setter
    def bounded_sequence_of_bounded_sequences(self, value: Collection[test_msgs.msg.BoundedSequences]) -> None: ...
    @property
    def bounded_sequence_of_unbounded_sequences(self) -> list[test_msgs.msg.UnboundedSequences]: ...
    @bounded_sequence_of_unbounded_sequences.setter
    def bounded_sequence_of_unbounded_sequences(self, value: Collection[test_msgs.msg.UnboundedSequences]) -> None: ...
    @property
    def unbounded_sequence_of_arrays(self) -> list[test_msgs.msg.Arrays]: ...
    @unbounded_sequence_of_arrays.setter
    def unbounded_sequence_of_arrays(self, value: Collection[test_msgs.msg.Arrays]) -> None: ...
    @property
    def unbounded_sequence_of_bounded_sequences(self) -> list[test_msgs.msg.BoundedSequences]: ...
    @unbounded_sequence_of_bounded_sequences.setter
    def unbounded_sequence_of_bounded_sequences(self, value: Collection[test_msgs.msg.BoundedSequences]) -> None: ...
    @property
    def unbounded_sequence_of_unbounded_sequences(self) -> list[test_msgs.msg.UnboundedSequences]: ...
    @unbounded_sequence_of_unbounded_sequences.setter
    def unbounded_sequence_of_unbounded_sequences(self, value: Collection[test_msgs.msg.UnboundedSequences]) -> None: ...

class Nested(Message):
    """test_msgs/msg/Nested

    # A message inside a message.

    BasicTypes basic_types_value
    """
    def __init__(self, *, basic_types_value: test_msgs.msg.BasicTypes = ..., check_fields: bool = ...) -> None: ...
    basic_types_value: test_msgs.msg.BasicTypes

class NonKeyedWithNestedKey(Message):
    """test_msgs/msg/NonKeyedWithNestedKey

    # A message with a field whose type has a key.

    KeyedString nested_data
    int32 some_int
    """
    def __init__(self, *, nested_data: test_msgs.msg.KeyedString = ..., some_int: int = ..., check_fields: bool = ...) -> None: ...
    nested_data: test_msgs.msg.KeyedString
    some_int: int

class Strings(Message):
    """test_msgs/msg/Strings

    # Strings with every kind of quoted default, with and without a bound.

    string string_value
    string string_value_default1 "Hello world!"
    string string_value_default2 "Hello'world!"
    string string_value_default3 'Hello"world!'
    string string_value_default4 'Hello\\'world!'
    string string_value_default5 "Hello\\"world!"
    string STRING_CONST="Hello world!"
    string<=22 bounded_string_value
    string<=22 bounded_string_value_default1 "Hello world!"
    string<=22 bounded_string_value_default2 "Hello'world!"
    string<=22 bounded_string_value_default3 'Hello"world!'
    string<=22 bounded_string_value_default4 'Hello\\'world!'
    string<=22 bounded_string_value_default5 "Hello\\"world!"
    """
    STRING_CONST: Final = 'Hello world!'
    def __init__(self, *, string_value: str = ..., string_value_default1: str = ..., string_value_default2: str = ..., string_value_default3: str = ..., string_value_default4: str = ..., string_value_default5: str = ..., bounded_string_value: str = ..., bounded_string_value_default1: str = ..., bounded_string_value_default2: str = ..., bounded_string_value_default3: str = ..., bounded_string_value_default4: str = ..., bounded_string_value_default5: str = ..., check_fields: bool = ...) -> None: ...
    string_value: str
    string_value_default1: str
    string_value_default2: str
    string_value_default3: str
    string_value_default4: str
    string_value_default5: str
    bounded_string_value: str
    bounded_string_value_default1: str
    bounded_string_value_default2: str
    bounded_string_value_default3: str
    bounded_string_value_default4: str
    bounded_string_value_default5: str

class UnboundedSequences(Message):
    """test_msgs/msg/UnboundedSequences

    # Sequences of any length of every type, without and with defaults.

    bool[] bool_values
    byte[] byte_values
    char[] char_values
    float32[] float32_values
    float64[] float64_values
    int8[] int8_values
    uint8[] uint8_values
    int16[] int16_values
    uint16[] uint16_values
    int32[] int32_values
    uint32[] uint32_values
    int64[] int64_values
    uint64[] uint64_values
    string[] string_values
    BasicTypes[] basic_types_values
    Constants[] constants_values
    Defaults[] defaults_values
    bool[] bool_values_default [false, true, false]
    byte[] byte_values_default [0, 1, 255]
    char[] char_values_default [0, 1, 127]
    float32[] float32_values_default [1.125, 0.0, -1.125]
    float64[] float64_values_default [3.1415, 0.0, -3.1415]
    int8[] int8_values_default [0, 127, -128]
    uint8[] uint8_values_default [0, 1, 255]
    int16[] int16_values_default [0, 32767, -32768]
    uint16[] uint16_values_default [0, 1, 65535]
    int32[] int32_values_default [0, 2147483647, -2147483648]
    uint32[] uint32_values_default [0, 1, 4294967295]
    int64[] int64_values_default [0, 9223372036854775807, -9223372036854775808]
    uint64[] uint64_values_default [0, 1, 18446744073709551615]
    string[] string_values_default ["", "max value", "min value"]
    int32 alignment_check
    """
    def __init__(self, *, bool_values: Collection[bool] = ..., byte_values: Collection[bytes] = ..., char_values: Collection[int] = ..., float32_values: Collection[float] = ..., float64_values: Collection[float] = ..., int8_values: Collection[int] = ..., uint8_values: Collection[int] = ..., int16_values: Collection[int] = ..., uint16_values: Collection[int] = ..., int32_values: Collection[int] = ..., uint32_values: Collection[int] = ..., int64_values: Collection[int] = ..., uint64_values: Collection[int] = ..., string_values: Collection[str] = ..., basic_types_values: Collection[test_msgs.msg.BasicTypes] = ..., constants_values: Collection[test_msgs.msg.Constants] = ..., defaults_values: Collection[test_msgs.msg.Defaults] = ..., bool_values_default: Collection[bool] = ..., byte_values_default: Collection[bytes] = ..., char_values_default: Collection[int] = ..., float32_values_default: Collection[float] = ..., float64_values_default: Collection[float] = ..., int8_values_default: Collection[int] = ..., uint8_values_default: Collection[int] = ..., int16_values_default: Collection[int] = ..., uint16_values_default: Collection[int] = ..., int32_values_default: Collection[int] = ..., uint32_values_default: Collection[int] = ..., int64_values_default: Collection[int] = ..., uint64_values_default: Collection[int] = ..., string_values_default: Collection[str] = ..., alignment_check: int = ..., check_fields: bool = ...) -> None: ...
    @property
    def bool_values(self) -> list[bool]: ...
    @bool_values.setter
    def bool_values(self, value: Collection[bool]) -> None: ...
    @property
    def byte_values(self) -> list[bytes]: ...
    @byte_values.setter
    def byte_values(self, value: Collection[bytes]) -> None: ...
    @property
    def char_values(self) -> array[int]: ...
    @char_values.setter
    def char_values(self, value: Collection[int]) -> None: ...
    @property
    def float32_values(self) -> array[float]: ...
    @float32_values.setter
    def float32_values(self, value: Collection[float]) -> None: ...
    @property
    def float64_values(self) -> array[float]: ...
    @float64_values.setter
    def float64_values(self, value: Collection[float]) -> None: ...
    @property
    def int8_values(self) -> array[int]: ...
    @int8_values.setter
    def int8_values(self, value: Collection[int]) -> None: ...
    @property
    def uint8_values(self) -> array[int]: ...
    @uint8_values.setter
    def uint8_values(self, value: Collection[int]) -> None: ...
    @property
    def int16_values(self) -> array[int]: ...
    @int16_values.setter
    def int16_values(self, value: Collection[int]) -> None: ...
    @property
    def uint16_values(self) -> array[int]: ...
    @uint16_values.setter
    def uint16_values(self, value: Collection[int]) -> None: ...
    @property
    def int32_values(self) -> array[int]: ...
    @int32_values.setter
    def int32_values(self, value: Collection[int]) -> None: ...
    @property
    def uint32_values(self) -> array[int]: ...
    @uint32_values.setter
    def uint32_values(self, value: Collection[int]) -> None: ...
    @property
    def int64_values(self) -> array[int]: ...
    @int64_values.setter
    def int64_values(self, value: Collection[int]) -> None: ...
    @property
    def uint64_values(self) -> array[int]: ...
    @uint64_values.setter
    def uint64_values(self, value: Collection[int]) -> None: ...
    @property
    def string_values(self) -> list[str]: ...
    @string_values.setter
    def string_values(self, value: Collection[str]) -> None: ...
    @property
    def basic_types_values(self) -> list[test_msgs.msg.BasicTypes]: ...
    @basic_types_values.setter
    def basic_types_values(self, value: Collection[test_msgs.msg.BasicTypes]) -> None: ...
    @property
    def constants_values(self) -> list[test_msgs.msg.Constants]: ...
    @constants_values.setter
    def constants_values(self, value: Collection[test_msgs.msg.Constants]) -> None: ...
    @property
    def defaults_values(self) -> list[test_msgs.msg.Defaults]: ...
    @defaults_values.setter
    def defaults_values(self, value: Collection[test_msgs.msg.Defaults]) -> None: ...
    @property
    def bool_values_default(self) -> list[bool]: ...
    @bool_values_default.setter
    def bool_values_default(self, value: Collection[bool]) -> None: ...
    @property
    def byte_values_default(self) -> list[bytes]: ...
    @byte_values_default.setter
    def byte_values_default(self, value: Collection[bytes]) -> None: ...
    @property
    def char_values_default(self) -> array[int]: ...
    @char_values_default.setter
    def char_values_default(self, value: Collection[int]) -> None: ...
    @property
    def float32_values_default(self) -> array[float]: ...
    @float32_values_default.setter
    def float32_values_default(self, value: Collection[float]) -> None: ...
    @property
    def float64_values_default(self) -> array[float]: ...
    @float64_values_default.setter
    def float64_values_default(self, value: Collection[float]) -> None: ...
    @property
    def int8_values_default(self) -> array[int]: ...
    @int8_values_default.setter
    def int8_values_default(self, value: Collection[int]) -> None: ...
    @property
    def uint8_values_default(self) -> array[int]: ...
    @uint8_values_default.setter
    def uint8_values_default(self, value: Collection[int]) -> None: ...
    @property
    def int16_values_default(self) -> array[int]: ...
    @int16_values_default.setter
    def int16_values_default(self, value: Collection[int]) -> None: ...
    @property
    def uint16_values_default(self) -> array[int]: ...
    @uint16_values_default.setter
    def uint16_values_default(self, value: Collection[int]) -> None: ...
    @property
    def int32_values_default(self) -> array[int]: ...
    @int32_values_default.setter
    def int32_values_default(self, value: Collection[int]) -> None: ...
    @property
    def uint32_values_default(self) -> array[int]: ...
    @uint32_values_default.setter
    def uint32_values_default(self, value: Collection[int]) -> None: ...
    @property
    def int64_values_default(self) -> array[int]: ...
    @int64_values_default.setter
    def int64_values_default(self, value: Collection[int]) -> None: ...
    @property
    def uint64_values_default(self) -> array[int]: ...
    @uint64_values_default.setter
    def uint64_values_default(self, value: Collection[int]) -> None: ...
    @property
    def string_values_default(self) -> list[str]: ...
    @string_values_default.setter
    def string_values_default(self, value: Collection[str]) -> None: ...
    alignment_check: int

class WStrings(Message):
    """test_msgs/msg/WStrings

    # Wide strings: single, with defaults, in arrays and sequences.

    wstring wstring_value
    wstring wstring_value_default1 "Hello world!"
    wstring wstring_value_default2 "Hellö wörld!"
    wstring wstring_value_default3 "ハローワールド"
    wstring[3] array_of_wstrings
    wstring[<=3] bounded_sequence_of_wstrings
    wstring[] unbounded_sequence_of_wstrings
    """
    def __init__(self, *, wstring_value: str = ..., wstring_value_default1: str = ..., wstring_value_default2: str = ..., wstring_value_default3: str = ..., array_of_wstrings: Collection[str] = ..., bounded_sequence_of_wstrings: Collection[str] = ..., unbounded_sequence_of_wstrings: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    wstring_value: str
    wstring_value_default1: str
    wstring_value_default2: str
    wstring_value_default3: str
    @property
    def array_of_wstrings(self) -> list[str]: ...
    @array_of_wstrings.setter
    def array_of_wstrings(self, value: Collection[str]) -> None: ...
    @property
    def bounded_sequence_of_wstrings(self) -> list[str]: ...
    @bounded_sequence_of_wstrings.setter
    def bounded_sequence_of_wstrings(self, value: Collection[str]) -> None: ...
    @property
    def unbounded_sequence_of_wstrings(self) -> list[str]: ...
    @unbounded_sequence_of_wstrings.setter
    def unbounded_sequence_of_wstrings(self, value: Collection[str]) -> None: ...
