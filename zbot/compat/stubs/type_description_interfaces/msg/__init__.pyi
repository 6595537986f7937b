# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import type_description_interfaces.msg
from zbot.interfaces import Action, Message, Service

class Field(Message):
    """type_description_interfaces/msg/Field

    # One field of a described type.

    # Name of the field.
    string name
    # What kind of value it holds.
    FieldType type
    # Its default as written in the definition, or an empty text.
    string default_value
    """
    def __init__(self, *, name: str = ..., type: type_description_interfaces.msg.FieldType = ..., default_value: str = ..., check_fields: bool = ...) -> None: ...
    name: str
    type: type_description_interfaces.msg.FieldType
    default_value: str

class FieldType(Message):
    """type_description_interfaces/msg/FieldType

    # What kind of value a field holds.

    # A number that was never filled in.
    uint8 FIELD_TYPE_NOT_SET = 0

    # Single values: a nested message, ...
    uint8 FIELD_TYPE_NESTED_TYPE = 1

    # ... whole numbers, ...
    uint8 FIELD_TYPE_INT8 = 2
    uint8 FIELD_TYPE_UINT8 = 3
    uint8 FIELD_TYPE_INT16 = 4
    uint8 FIELD_TYPE_UINT16 = 5
    uint8 FIELD_TYPE_INT32 = 6
    uint8 FIELD_TYPE_UINT32 = 7
    uint8 FIELD_TYPE_INT64 = 8
    uint8 FIELD_TYPE_UINT64 = 9

    # ... decimal numbers, ...
    uint8 FIELD_TYPE_FLOAT = 10
    uint8 FIELD_TYPE_DOUBLE = 11
    uint8 FIELD_TYPE_LONG_DOUBLE = 12

    # ... characters, ...
    uint8 FIELD_TYPE_CHAR = 13
    uint8 FIELD_TYPE_WCHAR = 14

    # ... truth values and raw bytes, ...
    uint8 FIELD_TYPE_BOOLEAN = 15
    uint8 FIELD_TYPE_BYTE = 16

    # ... and texts: of any length, of one fixed length, or up to a bound.
    uint8 FIELD_TYPE_STRING = 17
    uint8 FIELD_TYPE_WSTRING = 18
    uint8 FIELD_TYPE_FIXED_STRING = 19
    uint8 FIELD_TYPE_FIXED_WSTRING = 20
    uint8 FIELD_TYPE_BOUNDED_STRING = 21
    uint8 FIELD_TYPE_BOUNDED_WSTRING = 22

    # Arrays of a fixed size: 48 more than the single value.
    uint8 FIELD_TYPE_NESTED_TYPE_ARRAY = 49
    uint8 FIELD_TYPE_INT8_ARRAY = 50
    uint8 FIELD_TYPE_UINT8_ARRAY = 51
    uint8 FIELD_TYPE_INT16_ARRAY = 52
    uint8 FIELD_TYPE_UINT16_ARRAY = 53
    uint8 FIELD_TYPE_INT32_ARRAY = 54
    uint8 FIELD_TYPE_UINT32_ARRAY = 55
    uint8 FIELD_TYPE_INT64_ARRAY = 56
    uint8 FIELD_TYPE_UINT64_ARRAY = 57
    uint8 FIELD_TYPE_FLOAT_ARRAY = 58
    uint8 FIELD_TYPE_DOUBLE_ARRAY = 59
    uint8 FIELD_TYPE_LONG_DOUBLE_ARRAY = 60
    uint8 FIELD_TYPE_CHAR_ARRAY = 61
    uint8 FIELD_TYPE_WCHAR_ARRAY = 62
    uint8 FIELD_TYPE_BOOLEAN_ARRAY = 63
    uint8 FIELD_TYPE_BYTE_ARRAY = 64
    uint8 FIELD_TYPE_STRING_ARRAY = 65
    uint8 FIELD_TYPE_WSTRING_ARRAY = 66
    uint8 FIELD_TYPE_FIXED_STRING_ARRAY = 67
    uint8 FIELD_TYPE_FIXED_WSTRING_ARRAY = 68
    uint8 FIELD_TYPE_BOUNDED_STRING_ARRAY = 69
    uint8 FIELD_TYPE_BOUNDED_WSTRING_ARRAY = 70

    # Sequences up to a bound: 96 more.
    uint8 FIELD_TYPE_NESTED_TYPE_BOUNDED_SEQUENCE = 97
    uint8 FIELD_TYPE_INT8_BOUNDED_SEQUENCE = 98
    uint8 FIELD_TYPE_UINT8_BOUNDED_SEQUENCE = 99
    uint8 FIELD_TYPE_INT16_BOUNDED_SEQUENCE = 100
    uint8 FIELD_TYPE_UINT16_BOUNDED_SEQUENCE = 101
    uint8 FIELD_TYPE_INT32_BOUNDED_SEQUENCE = 102
    uint8 FIELD_TYPE_UINT32_BOUNDED_SEQUENCE = 103
    uint8 FIELD_TYPE_INT64_BOUNDED_SEQUENCE = 104
    uint8 FIELD_TYPE_UINT64_BOUNDED_SEQUENCE = 105
    uint8 FIELD_TYPE_FLOAT_BOUNDED_SEQUENCE = 106
    uint8 FIELD_TYPE_DOUBLE_BOUNDED_SEQUENCE = 107
    uint8 FIELD_TYPE_LONG_DOUBLE_BOUNDED_SEQUENCE = 108
    uint8 FIELD_TYPE_CHAR_BOUNDED_SEQUENCE = 109
    uint8 FIELD_TYPE_WCHAR_BOUNDED_SEQUENCE = 110
    uint8 FIELD_TYPE_BOOLEAN_BOUNDED_SEQUENCE = 111
    uint8 FIELD_TYPE_BYTE_BOUNDED_SEQUENCE = 112
    uint8 FIELD_TYPE_STRING_BOUNDED_SEQUENCE = 113
    uint8 FIELD_TYPE_WSTRING_BOUNDED_SEQUENCE = 114
    uint8 FIELD_TYPE_FIXED_STRING_BOUNDED_SEQUENCE = 115
    uint8 FIELD_TYPE_FIXED_WSTRING_BOUNDED_SEQUENCE = 116
    uint8 FIELD_TYPE_BOUNDED_STRING_BOUNDED_SEQUENCE = 117
    uint8 FIELD_TYPE_BOUNDED_WSTRING_BOUNDED_SEQUENCE = 118

    # Sequences of any length: 144 more.
    uint8 FIELD_TYPE_NESTED_TYPE_UNBOUNDED_SEQUENCE = 145
    uint8 FIELD_TYPE_INT8_UNBOUNDED_SEQUENCE = 146
    uint8 FIELD_TYPE_UINT8_UNBOUNDED_SEQUENCE = 147
    uint8 FIELD_TYPE_INT16_UNBOUNDED_SEQUENCE = 148
    uint8 FIELD_TYPE_UINT16_UNBOUNDED_SEQUENCE = 149
    uint8 FIELD_TYPE_INT32_UNBOUNDED_SEQUENCE = 150
    uint8 FIELD_TYPE_UINT32_UNBOUNDED_SEQUENCE = 151
    uint8 FIELD_TYPE_INT64_UNBOUNDED_SEQUENCE = 152
    uint8 FIELD_TYPE_UINT64_UNBOUNDED_SEQUENCE = 153
    uint8 FIELD_TYPE_FLOAT_UNBOUNDED_SEQUENCE = 154
    uint8 FIELD_TYPE_DOUBLE_UNBOUNDED_SEQUENCE = 155
    uint8 FIELD_TYPE_LONG_DOUBLE_UNBOUNDED_SEQUENCE = 156
    uint8 FIELD_TYPE_CHAR_UNBOUNDED_SEQUENCE = 157
    uint8 FIELD_TYPE_WCHAR_UNBOUNDED_SEQUENCE = 158
    uint8 FIELD_TYPE_BOOLEAN_UNBOUNDED_SEQUENCE = 159
    uint8 FIELD_TYPE_BYTE_UNBOUNDED_SEQUENCE = 160
    uint8 FIELD_TYPE_STRING_UNBOUNDED_SEQUENCE = 161
    uint8 FIELD_TYPE_WSTRING_UNBOUNDED_SEQUENCE = 162
    uint8 FIELD_TYPE_FIXED_STRING_UNBOUNDED_SEQUENCE = 163
    uint8 FIELD_TYPE_FIXED_WSTRING_UNBOUNDED_SEQUENCE = 164
    uint8 FIELD_TYPE_BOUNDED_STRING_UNBOUNDED_SEQUENCE = 165
    uint8 FIELD_TYPE_BOUNDED_WSTRING_UNBOUNDED_SEQUENCE = 166

    # One of the numbers above.
    uint8 type_id 0

    # Size of a fixed array, or bound of a bounded sequence; 0 otherwise.
    uint64 capacity

    # Length of a fixed text or bound of a bounded text, also inside arrays and sequences; 0 otherwise.
    uint64 string_capacity

    # Full name of a nested message, such as 'std_msgs/msg/Header'; empty otherwise.
    string<=255 nested_type_name
    """
    FIELD_TYPE_NOT_SET: Final = 0
    FIELD_TYPE_NESTED_TYPE: Final = 1
    FIELD_TYPE_INT8: Final = 2
    FIELD_TYPE_UINT8: Final = 3
    FIELD_TYPE_INT16: Final = 4
    FIELD_TYPE_UINT16: Final = 5
    FIELD_TYPE_INT32: Final = 6
    FIELD_TYPE_UINT32: Final = 7
    FIELD_TYPE_INT64: Final = 8
    FIELD_TYPE_UINT64: Final = 9
    FIELD_TYPE_FLOAT: Final = 10
    FIELD_TYPE_DOUBLE: Final = 11
    FIELD_TYPE_LONG_DOUBLE: Final = 12
    FIELD_TYPE_CHAR: Final = 13
    FIELD_TYPE_WCHAR: Final = 14
    FIELD_TYPE_BOOLEAN: Final = 15
    FIELD_TYPE_BYTE: Final = 16
    FIELD_TYPE_STRING: Final = 17
    FIELD_TYPE_WSTRING: Final = 18
    FIELD_TYPE_FIXED_STRING: Final = 19
    FIELD_TYPE_FIXED_WSTRING: Final = 20
    FIELD_TYPE_BOUNDED_STRING: Final = 21
    FIELD_TYPE_BOUNDED_WSTRING: Final = 22
    FIELD_TYPE_NESTED_TYPE_ARRAY: Final = 49
    FIELD_TYPE_INT8_ARRAY: Final = 50
    FIELD_TYPE_UINT8_ARRAY: Final = 51
    FIELD_TYPE_INT16_ARRAY: Final = 52
    FIELD_TYPE_UINT16_ARRAY: Final = 53
    FIELD_TYPE_INT32_ARRAY: Final = 54
    FIELD_TYPE_UINT32_ARRAY: Final = 55
    FIELD_TYPE_INT64_ARRAY: Final = 56
    FIELD_TYPE_UINT64_ARRAY: Final = 57
    FIELD_TYPE_FLOAT_ARRAY: Final = 58
    FIELD_TYPE_DOUBLE_ARRAY: Final = 59
    FIELD_TYPE_LONG_DOUBLE_ARRAY: Final = 60
    FIELD_TYPE_CHAR_ARRAY: Final = 61
    FIELD_TYPE_WCHAR_ARRAY: Final = 62
    FIELD_TYPE_BOOLEAN_ARRAY: Final = 63
    FIELD_TYPE_BYTE_ARRAY: Final = 64
    FIELD_TYPE_STRING_ARRAY: Final = 65
    FIELD_TYPE_WSTRING_ARRAY: Final = 66
    FIELD_TYPE_FIXED_STRING_ARRAY: Final = 67
    FIELD_TYPE_FIXED_WSTRING_ARRAY: Final = 68
    FIELD_TYPE_BOUNDED_STRING_ARRAY: Final = 69
    FIELD_TYPE_BOUNDED_WSTRING_ARRAY: Final = 70
    FIELD_TYPE_NESTED_TYPE_BOUNDED_SEQUENCE: Final = 97
    FIELD_TYPE_INT8_BOUNDED_SEQUENCE: Final = 98
    FIELD_TYPE_UINT8_BOUNDED_SEQUENCE: Final = 99
    FIELD_TYPE_INT16_BOUNDED_SEQUENCE: Final = 100
    FIELD_TYPE_UINT16_BOUNDED_SEQUENCE: Final = 101
    FIELD_TYPE_INT32_BOUNDED_SEQUENCE: Final = 102
    FIELD_TYPE_UINT32_BOUNDED_SEQUENCE: Final = 103
    FIELD_TYPE_INT64_BOUNDED_SEQUENCE: Final = 104
    FIELD_TYPE_UINT64_BOUNDED_SEQUENCE: Final = 105
    FIELD_TYPE_FLOAT_BOUNDED_SEQUENCE: Final = 106
    FIELD_TYPE_DOUBLE_BOUNDED_SEQUENCE: Final = 107
    FIELD_TYPE_LONG_DOUBLE_BOUNDED_SEQUENCE: Final = 108
    FIELD_TYPE_CHAR_BOUNDED_SEQUENCE: Final = 109
    FIELD_TYPE_WCHAR_BOUNDED_SEQUENCE: Final = 110
    FIELD_TYPE_BOOLEAN_BOUNDED_SEQUENCE: Final = 111
    FIELD_TYPE_BYTE_BOUNDED_SEQUENCE: Final = 112
    FIELD_TYPE_STRING_BOUNDED_SEQUENCE: Final = 113
    FIELD_TYPE_WSTRING_BOUNDED_SEQUENCE: Final = 114
    FIELD_TYPE_FIXED_STRING_BOUNDED_SEQUENCE: Final = 115
    FIELD_TYPE_FIXED_WSTRING_BOUNDED_SEQUENCE: Final = 116
    FIELD_TYPE_BOUNDED_STRING_BOUNDED_SEQUENCE: Final = 117
    FIELD_TYPE_BOUNDED_WSTRING_BOUNDED_SEQUENCE: Final = 118
    FIELD_TYPE_NESTED_TYPE_UNBOUNDED_SEQUENCE: Final = 145
    FIELD_TYPE_INT8_UNBOUNDED_SEQUENCE: Final = 146
    FIELD_TYPE_UINT8_UNBOUNDED_SEQUENCE: Final = 147
    FIELD_TYPE_INT16_UNBOUNDED_SEQUENCE: Final = 148
    FIELD_TYPE_UINT16_UNBOUNDED_SEQUENCE: Final = 149
    FIELD_TYPE_INT32_UNBOUNDED_SEQUENCE: Final = 150
    FIELD_TYPE_UINT32_UNBOUNDED_SEQUENCE: Final = 151
    FIELD_TYPE_INT64_UNBOUNDED_SEQUENCE: Final = 152
    FIELD_TYPE_UINT64_UNBOUNDED_SEQUENCE: Final = 153
    FIELD_TYPE_FLOAT_UNBOUNDED_SEQUENCE: Final = 154
    FIELD_TYPE_DOUBLE_UNBOUNDED_SEQUENCE: Final = 155
    FIELD_TYPE_LONG_DOUBLE_UNBOUNDED_SEQUENCE: Final = 156
    FIELD_TYPE_CHAR_UNBOUNDED_SEQUENCE: Final = 157
    FIELD_TYPE_WCHAR_UNBOUNDED_SEQUENCE: Final = 158
    FIELD_TYPE_BOOLEAN_UNBOUNDED_SEQUENCE: Final = 159
    FIELD_TYPE_BYTE_UNBOUNDED_SEQUENCE: Final = 160
    FIELD_TYPE_STRING_UNBOUNDED_SEQUENCE: Final = 161
    FIELD_TYPE_WSTRING_UNBOUNDED_SEQUENCE: Final = 162
    FIELD_TYPE_FIXED_STRING_UNBOUNDED_SEQUENCE: Final = 163
    FIELD_TYPE_FIXED_WSTRING_UNBOUNDED_SEQUENCE: Final = 164
    FIELD_TYPE_BOUNDED_STRING_UNBOUNDED_SEQUENCE: Final = 165
    FIELD_TYPE_BOUNDED_WSTRING_UNBOUNDED_SEQUENCE: Final = 166
    def __init__(self, *, type_id: int = ..., capacity: int = ..., string_capacity: int = ..., nested_type_name: str = ..., check_fields: bool = ...) -> None: ...
    type_id: int
    capacity: int
    string_capacity: int
    nested_type_name: str

class IndividualTypeDescription(Message):
    """type_description_interfaces/msg/IndividualTypeDescription

    # A single type and its fields, without the types they refer to.

    # Full name, such as 'std_msgs/msg/String'.
    string<=255 type_name
    # Its fields, in order.
    Field[] fields
    """
    def __init__(self, *, type_name: str = ..., fields: Collection[type_description_interfaces.msg.Field] = ..., check_fields: bool = ...) -> None: ...
    type_name: str
    @property
    def fields(self) -> list[type_description_interfaces.msg.Field]: ...
    @fields.setter
    def fields(self, value: Collection[type_description_interfaces.msg.Field]) -> None: ...

class KeyValue(Message):
    """type_description_interfaces/msg/KeyValue

    # A pair of texts for extra information.

    string key
    string value
    """
    def __init__(self, *, key: str = ..., value: str = ..., check_fields: bool = ...) -> None: ...
    key: str
    value: str

class TypeDescription(Message):
    """type_description_interfaces/msg/TypeDescription

    # A type with everything needed to understand it.

    # The type itself.
    IndividualTypeDescription type_description
    # Every type it refers to, directly or through others.
    IndividualTypeDescription[] referenced_type_descriptions
    """
    def __init__(self, *, type_description: type_description_interfaces.msg.IndividualTypeDescription = ..., referenced_type_descriptions: Collection[type_description_interfaces.msg.IndividualTypeDescription] = ..., check_fields: bool = ...) -> None: ...
    type_description: type_description_interfaces.msg.IndividualTypeDescription
    @property
    def referenced_type_descriptions(self) -> list[type_description_interfaces.msg.IndividualTypeDescription]: ...
    @referenced_type_descriptions.setter
    def referenced_type_descriptions(self, value: Collection[type_description_interfaces.msg.IndividualTypeDescription]) -> None: ...

class TypeSource(Message):
    """type_description_interfaces/msg/TypeSource

    # The text from which a type was made.

    # Full name, such as 'std_msgs/msg/String'.
    string type_name

    # Kind of text: "msg", "srv", "action" or "idl" like the ending of the file, "dynamic" for a type made
    # by a running program, "implicit" for a part of a service or action (its text is that of the whole).
    string encoding

    # The text; empty for "dynamic" and "implicit".
    string raw_file_contents
    """
    def __init__(self, *, type_name: str = ..., encoding: str = ..., raw_file_contents: str = ..., check_fields: bool = ...) -> None: ...
    type_name: str
    encoding: str
    raw_file_contents: str
