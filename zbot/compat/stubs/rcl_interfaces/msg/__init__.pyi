# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
import rcl_interfaces.msg
from zbot.interfaces import Action, Message, Service

class FloatingPointRange(Message):
    """rcl_interfaces/msg/FloatingPointRange

    # Limits of a decimal parameter.

    # Smallest allowed value.
    float64 from_value

    # Largest allowed value.
    float64 to_value

    # Distance between allowed values, counted from from_value; 0 allows everything in between and the
    # sign is ignored. to_value is always allowed, even when no whole number of steps leads to it:
    # from 0.5 to 1.5 in steps of 0.4 means 0.5, 0.9, 1.3 and 1.5.
    float64 step
    """
    def __init__(self, *, from_value: float = ..., to_value: float = ..., step: float = ..., check_fields: bool = ...) -> None: ...
    from_value: float
    to_value: float
    step: float

class IntegerRange(Message):
    """rcl_interfaces/msg/IntegerRange

    # Limits of a whole-number parameter.

    # Smallest allowed value.
    int64 from_value

    # Largest allowed value.
    int64 to_value

    # Distance between allowed values, counted from from_value; 0 allows everything in between.
    # to_value is always allowed, even when no whole number of steps leads to it: from 0 to 10 in
    # steps of 4 means 0, 4, 8 and 10.
    uint64 step
    """
    def __init__(self, *, from_value: int = ..., to_value: int = ..., step: int = ..., check_fields: bool = ...) -> None: ...
    from_value: int
    to_value: int
    step: int

class ListParametersResult(Message):
    """rcl_interfaces/msg/ListParametersResult

    # What a search for parameter names found.

    # Full names of the matching parameters.
    string[] names

    # Groups (the part of a name before its last dot) in which they were found.
    string[] prefixes
    """
    def __init__(self, *, names: Collection[str] = ..., prefixes: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def names(self) -> list[str]: ...
    @names.setter
    def names(self, value: Collection[str]) -> None: ...
    @property
    def prefixes(self) -> list[str]: ...
    @prefixes.setter
    def prefixes(self, value: Collection[str]) -> None: ...

class Log(Message):
    """rcl_interfaces/msg/Log

    # One line of a node's log, as sent on /rosout.

    # Levels are spaced as in Python's logging module, which leaves room for others in between.

    # Details that help to find a bug.
    uint8 DEBUG=10

    # Normal progress.
    uint8 INFO=20

    # Something odd that may lead to trouble.
    uint8 WARN=30

    # Something failed, and this node cannot repair it.
    uint8 ERROR=40

    # The node is about to stop.
    uint8 FATAL=50

    # When the line was written.
    builtin_interfaces/Time stamp

    # One of the levels above.
    uint8 level

    # Which logger wrote it, usually the name of the node.
    string name

    # The text itself.
    string msg

    # Where in the source code it was written.
    string file
    string function
    uint32 line
    """
    DEBUG: Final = 10
    INFO: Final = 20
    WARN: Final = 30
    ERROR: Final = 40
    FATAL: Final = 50
    def __init__(self, *, stamp: builtin_interfaces.msg.Time = ..., level: int = ..., name: str = ..., msg: str = ..., file: str = ..., function: str = ..., line: int = ..., check_fields: bool = ...) -> None: ...
    stamp: builtin_interfaces.msg.Time
    level: int
    name: str
    msg: str
    file: str
    function: str
    line: int

class LoggerLevel(Message):
    """rcl_interfaces/msg/LoggerLevel

    # The lowest level at which a logger lets lines through.

    uint8 LOG_LEVEL_UNKNOWN = 0
    uint8 LOG_LEVEL_DEBUG = 10
    uint8 LOG_LEVEL_INFO = 20
    uint8 LOG_LEVEL_WARN = 30
    uint8 LOG_LEVEL_ERROR = 40
    uint8 LOG_LEVEL_FATAL = 50

    # Which logger; usually the name of a node.
    string name

    # One of the levels above.
    uint32 level
    """
    LOG_LEVEL_UNKNOWN: Final = 0
    LOG_LEVEL_DEBUG: Final = 10
    LOG_LEVEL_INFO: Final = 20
    LOG_LEVEL_WARN: Final = 30
    LOG_LEVEL_ERROR: Final = 40
    LOG_LEVEL_FATAL: Final = 50
    def __init__(self, *, name: str = ..., level: int = ..., check_fields: bool = ...) -> None: ...
    name: str
    level: int

class Parameter(Message):
    """rcl_interfaces/msg/Parameter

    # A named setting of a node.

    # Full name; dots make groups, as in 'camera.exposure'.
    string name

    # Its value, together with the kind of value.
    ParameterValue value
    """
    def __init__(self, *, name: str = ..., value: rcl_interfaces.msg.ParameterValue = ..., check_fields: bool = ...) -> None: ...
    name: str
    value: rcl_interfaces.msg.ParameterValue

class ParameterDescriptor(Message):
    """rcl_interfaces/msg/ParameterDescriptor

    # What is known about a parameter besides its value: kind, purpose and limits.

    # Name of the parameter.
    string name

    # Kind of value, one of the constants in ParameterType.
    uint8 type

    # What it is for, shown by tools.
    string description

    # Limits that the ranges below cannot express, in words: "must be a prime number".
    string additional_constraints

    # True: fixed once the node has set it.
    bool read_only false

    # True: its value may change from one kind to another.
    bool dynamic_typing false

    # Limits of the value. At most one of the two holds an entry.
    FloatingPointRange[<=1] floating_point_range
    IntegerRange[<=1] integer_range
    """
    def __init__(self, *, name: str = ..., type: int = ..., description: str = ..., additional_constraints: str = ..., read_only: bool = ..., dynamic_typing: bool = ..., floating_point_range: Collection[rcl_interfaces.msg.FloatingPointRange] = ..., integer_range: Collection[rcl_interfaces.msg.IntegerRange] = ..., check_fields: bool = ...) -> None: ...
    name: str
    type: int
    description: str
    additional_constraints: str
    read_only: bool
    dynamic_typing: bool
    @property
    def floating_point_range(self) -> list[rcl_interfaces.msg.FloatingPointRange]: ...
    @floating_point_range.setter
    def floating_point_range(self, value: Collection[rcl_interfaces.msg.FloatingPointRange]) -> None: ...
    @property
    def integer_range(self) -> list[rcl_interfaces.msg.IntegerRange]: ...
    @integer_range.setter
    def integer_range(self, value: Collection[rcl_interfaces.msg.IntegerRange]) -> None: ...

class ParameterEvent(Message):
    """rcl_interfaces/msg/ParameterEvent

    # Tells everybody that parameters of a node changed, as sent on /parameter_events.
    # One event is one change made in one go, so each name appears in a single list only.

    # When it happened.
    builtin_interfaces/Time stamp

    # Full name of the node, with its namespace.
    string node

    # Declared just now.
    Parameter[] new_parameters

    # Existed before and got another value.
    Parameter[] changed_parameters

    # No longer there.
    Parameter[] deleted_parameters
    """
    def __init__(self, *, stamp: builtin_interfaces.msg.Time = ..., node: str = ..., new_parameters: Collection[rcl_interfaces.msg.Parameter] = ..., changed_parameters: Collection[rcl_interfaces.msg.Parameter] = ..., deleted_parameters: Collection[rcl_interfaces.msg.Parameter] = ..., check_fields: bool = ...) -> None: ...
    stamp: builtin_interfaces.msg.Time
    node: str
    @property
    def new_parameters(self) -> list[rcl_interfaces.msg.Parameter]: ...
    @new_parameters.setter
    def new_parameters(self, value: Collection[rcl_interfaces.msg.Parameter]) -> None: ...
    @property
    def changed_parameters(self) -> list[rcl_interfaces.msg.Parameter]: ...
    @changed_parameters.setter
    def changed_parameters(self, value: Collection[rcl_interfaces.msg.Parameter]) -> None: ...
    @property
    def deleted_parameters(self) -> list[rcl_interfaces.msg.Parameter]: ...
    @deleted_parameters.setter
    def deleted_parameters(self, value: Collection[rcl_interfaces.msg.Parameter]) -> None: ...

class ParameterEventDescriptors(Message):
    """rcl_interfaces/msg/ParameterEventDescriptors

    # Descriptors of the parameters that one event touched; each name appears in a single list only.

    ParameterDescriptor[] new_parameters
    ParameterDescriptor[] changed_parameters
    ParameterDescriptor[] deleted_parameters
    """
    def __init__(self, *, new_parameters: Collection[rcl_interfaces.msg.ParameterDescriptor] = ..., changed_parameters: Collection[rcl_interfaces.msg.ParameterDescriptor] = ..., deleted_parameters: Collection[rcl_interfaces.msg.ParameterDescriptor] = ..., check_fields: bool = ...) -> None: ...
    @property
    def new_parameters(self) -> list[rcl_interfaces.msg.ParameterDescriptor]: ...
    @new_parameters.setter
    def new_parameters(self, value: Collection[rcl_interfaces.msg.ParameterDescriptor]) -> None: ...
    @property
    def changed_parameters(self) -> list[rcl_interfaces.msg.ParameterDescriptor]: ...
    @changed_parameters.setter
    def changed_parameters(self, value: Collection[rcl_interfaces.msg.ParameterDescriptor]) -> None: ...
    @property
    def deleted_parameters(self) -> list[rcl_interfaces.msg.ParameterDescriptor]: ...
    @deleted_parameters.setter
    def deleted_parameters(self, value: Collection[rcl_interfaces.msg.ParameterDescriptor]) -> None: ...

class ParameterType(Message):
    """rcl_interfaces/msg/ParameterType

    # The kinds of value a parameter can hold.

    # No value.
    uint8 PARAMETER_NOT_SET=0

    uint8 PARAMETER_BOOL=1
    uint8 PARAMETER_INTEGER=2
    uint8 PARAMETER_DOUBLE=3
    uint8 PARAMETER_STRING=4
    uint8 PARAMETER_BYTE_ARRAY=5
    uint8 PARAMETER_BOOL_ARRAY=6
    uint8 PARAMETER_INTEGER_ARRAY=7
    uint8 PARAMETER_DOUBLE_ARRAY=8
    uint8 PARAMETER_STRING_ARRAY=9
    """
    PARAMETER_NOT_SET: Final = 0
    PARAMETER_BOOL: Final = 1
    PARAMETER_INTEGER: Final = 2
    PARAMETER_DOUBLE: Final = 3
    PARAMETER_STRING: Final = 4
    PARAMETER_BYTE_ARRAY: Final = 5
    PARAMETER_BOOL_ARRAY: Final = 6
    PARAMETER_INTEGER_ARRAY: Final = 7
    PARAMETER_DOUBLE_ARRAY: Final = 8
    PARAMETER_STRING_ARRAY: Final = 9
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class ParameterValue(Message):
    """rcl_interfaces/msg/ParameterValue

    # A value of one of several kinds: type says which of the other fields counts, the rest stay empty.

    # One of the constants in ParameterType; PARAMETER_NOT_SET for no value.
    uint8 type

    # PARAMETER_BOOL
    bool bool_value

    # PARAMETER_INTEGER
    int64 integer_value

    # PARAMETER_DOUBLE
    float64 double_value

    # PARAMETER_STRING
    string string_value

    # PARAMETER_BYTE_ARRAY
    byte[] byte_array_value

    # PARAMETER_BOOL_ARRAY
    bool[] bool_array_value

    # PARAMETER_INTEGER_ARRAY
    int64[] integer_array_value

    # PARAMETER_DOUBLE_ARRAY
    float64[] double_array_value

    # PARAMETER_STRING_ARRAY
    string[] string_array_value
    """
    def __init__(self, *, type: int = ..., bool_value: bool = ..., integer_value: int = ..., double_value: float = ..., string_value: str = ..., byte_array_value: Collection[bytes] = ..., bool_array_value: Collection[bool] = ..., integer_array_value: Collection[int] = ..., double_array_value: Collection[float] = ..., string_array_value: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    type: int
    bool_value: bool
    integer_value: int
    double_value: float
    string_value: str
    @property
    def byte_array_value(self) -> list[bytes]: ...
    @byte_array_value.setter
    def byte_array_value(self, value: Collection[bytes]) -> None: ...
    @property
    def bool_array_value(self) -> list[bool]: ...
    @bool_array_value.setter
    def bool_array_value(self, value: Collection[bool]) -> None: ...
    @property
    def integer_array_value(self) -> array[int]: ...
    @integer_array_value.setter
    def integer_array_value(self, value: Collection[int]) -> None: ...
    @property
    def double_array_value(self) -> array[float]: ...
    @double_array_value.setter
    def double_array_value(self, value: Collection[float]) -> None: ...
    @property
    def string_array_value(self) -> list[str]: ...
    @string_array_value.setter
    def string_array_value(self, value: Collection[str]) -> None: ...

class SetLoggerLevelsResult(Message):
    """rcl_interfaces/msg/SetLoggerLevelsResult

    # Whether a logger took its new level.

    # True if it did.
    bool successful

    # Why not, or further details.
    string reason
    """
    def __init__(self, *, successful: bool = ..., reason: str = ..., check_fields: bool = ...) -> None: ...
    successful: bool
    reason: str

class SetParametersResult(Message):
    """rcl_interfaces/msg/SetParametersResult

    # Whether a parameter took its new value.

    # False if the node refused it.
    bool successful

    # Why it was refused, for people to read; means nothing on success.
    string reason
    """
    def __init__(self, *, successful: bool = ..., reason: str = ..., check_fields: bool = ...) -> None: ...
    successful: bool
    reason: str
