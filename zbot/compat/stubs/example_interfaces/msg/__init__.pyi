# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import example_interfaces.msg
from zbot.interfaces import Action, Message, Service

class Bool(Message):
    """example_interfaces/msg/Bool

    # A yes or no, such as a switch, a button or a contact.

    bool data
    """
    def __init__(self, *, data: bool = ..., check_fields: bool = ...) -> None: ...
    data: bool

class Byte(Message):
    """example_interfaces/msg/Byte

    # A single raw byte; in Python a bytes object of length 1, such as b'\\x07'.

    byte data
    """
    def __init__(self, *, data: bytes = ..., check_fields: bool = ...) -> None: ...
    data: bytes

class ByteMultiArray(Message):
    """example_interfaces/msg/ByteMultiArray

    # A list or table of raw bytes; its layout may stay empty for a plain list.

    MultiArrayLayout  layout        # how data folds into rows and columns
    byte[]            data          # all elements, one after the other
    """
    def __init__(self, *, layout: example_interfaces.msg.MultiArrayLayout = ..., data: Collection[bytes] = ..., check_fields: bool = ...) -> None: ...
    layout: example_interfaces.msg.MultiArrayLayout
    @property
    def data(self) -> list[bytes]: ...
    @data.setter
    def data(self, value: Collection[bytes]) -> None: ...

class Char(Message):
    """example_interfaces/msg/Char

    # A single character code from 0 to 255; in Python an int.

    char data
    """
    def __init__(self, *, data: int = ..., check_fields: bool = ...) -> None: ...
    data: int

class Empty(Message):
    """example_interfaces/msg/Empty

    # Carries nothing: the arrival itself is the signal.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Float32(Message):
    """example_interfaces/msg/Float32

    # A decimal number of about 7 digits, such as one sensor reading.

    float32 data
    """
    def __init__(self, *, data: float = ..., check_fields: bool = ...) -> None: ...
    data: float

class Float32MultiArray(Message):
    """example_interfaces/msg/Float32MultiArray

    # A list or table of 32-bit decimal numbers; its layout may stay empty for a plain list.

    MultiArrayLayout  layout        # how data folds into rows and columns
    float32[]         data          # all elements, one after the other
    """
    def __init__(self, *, layout: example_interfaces.msg.MultiArrayLayout = ..., data: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    layout: example_interfaces.msg.MultiArrayLayout
    @property
    def data(self) -> array[float]: ...
    @data.setter
    def data(self, value: Collection[float]) -> None: ...

class Float64(Message):
    """example_interfaces/msg/Float64

    # A decimal number of about 15 digits, the precision of a Python float.

    float64 data
    """
    def __init__(self, *, data: float = ..., check_fields: bool = ...) -> None: ...
    data: float

class Float64MultiArray(Message):
    """example_interfaces/msg/Float64MultiArray

    # A list or table of 64-bit decimal numbers; its layout may stay empty for a plain list.

    MultiArrayLayout  layout        # how data folds into rows and columns
    float64[]         data          # all elements, one after the other
    """
    def __init__(self, *, layout: example_interfaces.msg.MultiArrayLayout = ..., data: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    layout: example_interfaces.msg.MultiArrayLayout
    @property
    def data(self) -> array[float]: ...
    @data.setter
    def data(self, value: Collection[float]) -> None: ...

class Int16(Message):
    """example_interfaces/msg/Int16

    # A whole number from -32768 to 32767.

    int16 data
    """
    def __init__(self, *, data: int = ..., check_fields: bool = ...) -> None: ...
    data: int

class Int16MultiArray(Message):
    """example_interfaces/msg/Int16MultiArray

    # A list or table of signed 16-bit whole numbers; its layout may stay empty for a plain list.

    MultiArrayLayout  layout        # how data folds into rows and columns
    int16[]           data          # all elements, one after the other
    """
    def __init__(self, *, layout: example_interfaces.msg.MultiArrayLayout = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    layout: example_interfaces.msg.MultiArrayLayout
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class Int32(Message):
    """example_interfaces/msg/Int32

    # A whole number from -2147483648 to 2147483647, the usual choice for counters.

    int32 data
    """
    def __init__(self, *, data: int = ..., check_fields: bool = ...) -> None: ...
    data: int

class Int32MultiArray(Message):
    """example_interfaces/msg/Int32MultiArray

    # A list or table of signed 32-bit whole numbers; its layout may stay empty for a plain list.

    MultiArrayLayout  layout        # how data folds into rows and columns
    int32[]           data          # all elements, one after the other
    """
    def __init__(self, *, layout: example_interfaces.msg.MultiArrayLayout = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    layout: example_interfaces.msg.MultiArrayLayout
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class Int64(Message):
    """example_interfaces/msg/Int64

    # A whole number from -2**63 to 2**63 - 1.

    int64 data
    """
    def __init__(self, *, data: int = ..., check_fields: bool = ...) -> None: ...
    data: int

class Int64MultiArray(Message):
    """example_interfaces/msg/Int64MultiArray

    # A list or table of signed 64-bit whole numbers; its layout may stay empty for a plain list.

    MultiArrayLayout  layout        # how data folds into rows and columns
    int64[]           data          # all elements, one after the other
    """
    def __init__(self, *, layout: example_interfaces.msg.MultiArrayLayout = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    layout: example_interfaces.msg.MultiArrayLayout
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class Int8(Message):
    """example_interfaces/msg/Int8

    # A whole number from -128 to 127.

    int8 data
    """
    def __init__(self, *, data: int = ..., check_fields: bool = ...) -> None: ...
    data: int

class Int8MultiArray(Message):
    """example_interfaces/msg/Int8MultiArray

    # A list or table of signed 8-bit whole numbers; its layout may stay empty for a plain list.

    MultiArrayLayout  layout        # how data folds into rows and columns
    int8[]            data          # all elements, one after the other
    """
    def __init__(self, *, layout: example_interfaces.msg.MultiArrayLayout = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    layout: example_interfaces.msg.MultiArrayLayout
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class MultiArrayDimension(Message):
    """example_interfaces/msg/MultiArrayDimension

    # One axis of a multi-dimensional array; see MultiArrayLayout.

    string label   # name of the axis, such as "row"
    uint32 size    # number of entries along this axis
    uint32 stride  # elements covered by this axis and all axes inside it
    """
    def __init__(self, *, label: str = ..., size: int = ..., stride: int = ..., check_fields: bool = ...) -> None: ...
    label: str
    size: int
    stride: int

class MultiArrayLayout(Message):
    """example_interfaces/msg/MultiArrayLayout

    # How the flat data of a multi-array folds into rows, columns and further axes.
    #
    # Axes are listed from the outermost to the innermost. The stride of an axis is its own size times
    # the sizes of all axes after it, so dim[0].stride is the number of elements of the whole array.
    # The element at (i, j, k) is found at
    #   data[data_offset + i * dim[1].stride + j * dim[2].stride + k]
    #
    # Example: 2 rows of 3 columns
    #   dim[0]: label "row",    size 2, stride 6
    #   dim[1]: label "column", size 3, stride 3

    MultiArrayDimension[] dim # the axes, outermost first
    uint32 data_offset        # elements to skip at the start of data
    """
    def __init__(self, *, dim: Collection[example_interfaces.msg.MultiArrayDimension] = ..., data_offset: int = ..., check_fields: bool = ...) -> None: ...
    @property
    def dim(self) -> list[example_interfaces.msg.MultiArrayDimension]: ...
    @dim.setter
    def dim(self, value: Collection[example_interfaces.msg.MultiArrayDimension]) -> None: ...
    data_offset: int

class String(Message):
    """example_interfaces/msg/String

    # A text. Handy for first experiments; real data deserves a message type whose name says what it is.

    string data
    """
    def __init__(self, *, data: str = ..., check_fields: bool = ...) -> None: ...
    data: str

class UInt16(Message):
    """example_interfaces/msg/UInt16

    # A whole number from 0 to 65535.

    uint16 data
    """
    def __init__(self, *, data: int = ..., check_fields: bool = ...) -> None: ...
    data: int

class UInt16MultiArray(Message):
    """example_interfaces/msg/UInt16MultiArray

    # A list or table of unsigned 16-bit whole numbers; its layout may stay empty for a plain list.

    MultiArrayLayout  layout        # how data folds into rows and columns
    uint16[]            data        # all elements, one after the other
    """
    def __init__(self, *, layout: example_interfaces.msg.MultiArrayLayout = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    layout: example_interfaces.msg.MultiArrayLayout
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class UInt32(Message):
    """example_interfaces/msg/UInt32

    # A whole number from 0 to 4294967295.

    uint32 data
    """
    def __init__(self, *, data: int = ..., check_fields: bool = ...) -> None: ...
    data: int

class UInt32MultiArray(Message):
    """example_interfaces/msg/UInt32MultiArray

    # A list or table of unsigned 32-bit whole numbers; its layout may stay empty for a plain list.

    MultiArrayLayout  layout        # how data folds into rows and columns
    uint32[]          data          # all elements, one after the other
    """
    def __init__(self, *, layout: example_interfaces.msg.MultiArrayLayout = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    layout: example_interfaces.msg.MultiArrayLayout
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class UInt64(Message):
    """example_interfaces/msg/UInt64

    # A whole number from 0 to 2**64 - 1.

    uint64 data
    """
    def __init__(self, *, data: int = ..., check_fields: bool = ...) -> None: ...
    data: int

class UInt64MultiArray(Message):
    """example_interfaces/msg/UInt64MultiArray

    # A list or table of unsigned 64-bit whole numbers; its layout may stay empty for a plain list.

    MultiArrayLayout  layout        # how data folds into rows and columns
    uint64[]          data          # all elements, one after the other
    """
    def __init__(self, *, layout: example_interfaces.msg.MultiArrayLayout = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    layout: example_interfaces.msg.MultiArrayLayout
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class UInt8(Message):
    """example_interfaces/msg/UInt8

    # A whole number from 0 to 255.

    uint8 data
    """
    def __init__(self, *, data: int = ..., check_fields: bool = ...) -> None: ...
    data: int

class UInt8MultiArray(Message):
    """example_interfaces/msg/UInt8MultiArray

    # A list or table of unsigned 8-bit whole numbers; its layout may stay empty for a plain list.

    MultiArrayLayout  layout        # how data folds into rows and columns
    uint8[]           data          # all elements, one after the other
    """
    def __init__(self, *, layout: example_interfaces.msg.MultiArrayLayout = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    layout: example_interfaces.msg.MultiArrayLayout
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class WString(Message):
    """example_interfaces/msg/WString

    # A text of 16-bit characters. In Python a str like any other; prefer string, which is smaller.

    wstring data
    """
    def __init__(self, *, data: str = ..., check_fields: bool = ...) -> None: ...
    data: str
