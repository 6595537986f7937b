"""Specs, the contents of definitions: fields, constants and parts."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal, NamedTuple, Union

Scalar = Union[bool, int, float, str, bytes]  # noqa: UP007 - evaluated at run time on Python 3.10
Kind = Literal["scalar", "array", "sequence"]

#: Range of each integer type. In a definition's text, `byte` and `char` are 0..255.
INTEGER_RANGES: dict[str, tuple[int, int]] = {
    "int8": (-(2**7), 2**7 - 1),
    "uint8": (0, 2**8 - 1),
    "char": (0, 2**8 - 1),
    "int16": (-(2**15), 2**15 - 1),
    "uint16": (0, 2**16 - 1),
    "int32": (-(2**31), 2**31 - 1),
    "uint32": (0, 2**32 - 1),
    "int64": (-(2**63), 2**63 - 1),
    "uint64": (0, 2**64 - 1),
}
#: Typecode of Python's `array` for each numeric type. The array's items have the type's size.
TYPECODES: dict[str, str] = {
    "int8": "b",
    "uint8": "B",
    "char": "B",
    "int16": "h",
    "uint16": "H",
    "int32": "i",
    "uint32": "I",
    "int64": "q",
    "uint64": "Q",
    "float32": "f",
    "float64": "d",
}
FLOAT32_MAX = 3.4028234663852886e38
STRING_TYPES = ("string", "wstring")
PRIMITIVES = ("bool", "byte", *TYPECODES, *STRING_TYPES)

# IDL's names of types. get_fields_and_field_types() returns them in place of a .msg file's names.
_IDL_NAMES = {
    "bool": "boolean",
    "byte": "octet",
    "char": "uint8",
    "float32": "float",
    "float64": "double",
}


class FieldType(NamedTuple):
    """The type of one field.

    `str()` returns ROS 2's text in `get_fields_and_field_types()`, e.g. `sequence<double, 3>`.
    """

    base: str  #: `float64`, `string` ... or the full name of a message, `geometry_msgs/msg/Point`
    kind: Kind = "scalar"
    size: int = 0  #: N of `T[N]` or `T[<=N]`, or 0 without a bound
    string_bound: int = 0  #: N of `string<=N`, in characters, or 0 without a bound

    @property
    def is_message(self) -> bool:
        """Whether the base is another message."""
        return "/" in self.base

    @property
    def is_string(self) -> bool:
        """Whether the base is `string` or `wstring`."""
        return self.base in STRING_TYPES

    @property
    def typecode(self) -> str:
        """The `array.array` typecode of a numeric base, or `""` for any other base."""
        return TYPECODES.get(self.base, "")

    @property
    def text(self) -> str:
        """The type as a definition writes it: `float64[<=3]`, `string<=10`."""
        text = _without_kind(self.base)
        if self.string_bound:
            text += f"<={self.string_bound}"
        if self.kind == "array":
            return f"{text}[{self.size}]"
        if self.kind == "sequence":
            return f"{text}[<={self.size}]" if self.size else f"{text}[]"
        return text

    def __str__(self) -> str:
        text = _IDL_NAMES.get(self.base) or _without_kind(self.base)
        if self.string_bound:
            text += f"<{self.string_bound}>"
        if self.kind == "array":
            return f"{text}[{self.size}]"
        if self.kind == "sequence":
            return f"sequence<{text}, {self.size}>" if self.size else f"sequence<{text}>"
        return text


@dataclass(frozen=True, slots=True)
class Field:
    """One field of a message."""

    name: str
    type: FieldType
    default: Scalar | tuple[Scalar, ...] | None = None  #: None means the type's zero value
    line: int = field(default=0, compare=False)  #: line in the file, from 1, or 0 without a file


@dataclass(frozen=True, slots=True)
class Constant:
    """One constant of a message. A `byte` constant is `bytes` of length 1."""

    name: str
    type: FieldType
    value: Scalar
    line: int = field(default=0, compare=False)  #: line in the file, from 1


class _Named:
    __slots__ = ()
    name: str

    @property
    def package(self) -> str:
        """The first part of the name."""
        return self.name.split("/", 1)[0]


@dataclass(frozen=True, slots=True)
class MessageSpec(_Named):
    """A message, which can be a part of a service or an action."""

    name: str  #: `std_msgs/msg/String`, `std_srvs/srv/SetBool_Request`
    fields: tuple[Field, ...]
    constants: tuple[Constant, ...] = ()
    text: str = field(default="", compare=False)  #: the definition with its comments


@dataclass(frozen=True, slots=True)
class ServiceSpec(_Named):
    """A service and the messages made from it."""

    name: str  #: `std_srvs/srv/SetBool`
    request: MessageSpec
    response: MessageSpec
    event: MessageSpec
    text: str = field(default="", compare=False)  #: the definition with its comments


@dataclass(frozen=True, slots=True)
class ActionSpec(_Named):
    """An action, with the messages and services made from it."""

    name: str  #: `example_interfaces/action/Fibonacci`
    goal: MessageSpec
    result: MessageSpec
    feedback: MessageSpec
    send_goal: ServiceSpec
    get_result: ServiceSpec
    feedback_message: MessageSpec
    text: str = field(default="", compare=False)  #: the definition with its comments


InterfaceSpec = Union[MessageSpec, ServiceSpec, ActionSpec]  # noqa: UP007 - see Scalar


def parts_of(spec: InterfaceSpec) -> tuple[InterfaceSpec, ...]:
    """Return the parts of a service or an action. The result is empty for a message."""
    if isinstance(spec, ServiceSpec):
        return spec.request, spec.response, spec.event
    if isinstance(spec, ActionSpec):
        messages = (spec.goal, spec.result, spec.feedback, spec.feedback_message)
        return *messages, spec.send_goal, spec.get_result
    return ()


def _without_kind(base: str) -> str:
    """Return `geometry_msgs/Point` for `geometry_msgs/msg/Point`. Primitive types do not change."""
    first, slash, rest = base.partition("/")
    return f"{first}/{rest.rpartition('/')[2]}" if slash else base


_GOAL_ID = Field("goal_id", FieldType("unique_identifier_msgs/msg/UUID"))
_STAMP = Field("stamp", FieldType("builtin_interfaces/msg/Time"))
_INFO = Field("info", FieldType("service_msgs/msg/ServiceEventInfo"))


def service_spec(
    name: str, request: MessageSpec, response: MessageSpec, text: str = ""
) -> ServiceSpec:
    """Return a service of two messages, with the `_Event` message of service introspection."""
    event = MessageSpec(
        f"{name}_Event",
        (
            _INFO,
            Field("request", FieldType(request.name, "sequence", 1)),
            Field("response", FieldType(response.name, "sequence", 1)),
        ),
    )
    return ServiceSpec(name, request, response, event, text)


def action_spec(
    name: str, goal: MessageSpec, result: MessageSpec, feedback: MessageSpec, text: str = ""
) -> ActionSpec:
    """Return an action of three messages, and the services and message that contain these three."""
    return ActionSpec(
        name,
        goal,
        result,
        feedback,
        _send_goal(name, goal),
        _get_result(name, result),
        MessageSpec(
            f"{name}_FeedbackMessage", (_GOAL_ID, Field("feedback", FieldType(feedback.name)))
        ),
        text,
    )


def _send_goal(action_name: str, goal: MessageSpec) -> ServiceSpec:
    name = f"{action_name}_SendGoal"
    request = MessageSpec(f"{name}_Request", (_GOAL_ID, Field("goal", FieldType(goal.name))))
    response = MessageSpec(f"{name}_Response", (Field("accepted", FieldType("bool")), _STAMP))
    return service_spec(name, request, response)


def _get_result(action_name: str, result: MessageSpec) -> ServiceSpec:
    name = f"{action_name}_GetResult"
    request = MessageSpec(f"{name}_Request", (_GOAL_ID,))
    fields = (Field("status", FieldType("int8")), Field("result", FieldType(result.name)))
    return service_spec(name, request, MessageSpec(f"{name}_Response", fields))
