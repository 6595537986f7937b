"""Parameters with name, type and value, and their conversion from and to messages and YAML."""

from __future__ import annotations

import array
import re
import warnings
from enum import IntEnum
from typing import TYPE_CHECKING, Any, Generic, TypeVar, cast, overload

from zbot.errors import ArgumentTypeError, ParameterError, WrongStateError, ZbotError
from zbot.errors.call_source import field_read_from
from zbot.parameters.errors import ParameterValueError, advice_for_override
from zbot.parameters.file import matches, parse_value, sections
from zbot.text.yaml_reader import YamlError, read_yaml

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rcl_interfaces.msg import Parameter as ParameterMsg
    from rcl_interfaces.msg import ParameterValue

__all__ = [
    "PARAMETER_SEPARATOR_STRING",
    "AllowableParameterValue",
    "InvalidParameterTypeException",
    "Parameter",
    "get_parameter_value",
    "parameter_dict_from_yaml_file",
    "parameter_value_to_python",
]

PARAMETER_SEPARATOR_STRING = "."

#: A bool, int, float, str or None, or a list, tuple or array. The items of a list, tuple or array
#: are of type bool, int, float or str, or are bytes of length 1.
AllowableParameterValue = Any
ValueT_co = TypeVar("ValueT_co", covariant=True)

_EXPONENT = re.compile(r"[-+]?[0-9]+[eE][-+]?[0-9]+")
_INT64 = range(-(2**63), 2**63)


class ParameterTypeError(ZbotError, TypeError):
    """A value has a type that no parameter can have."""

    def __init__(self, value: object) -> None:
        self.value = value
        many = isinstance(value, (list, tuple, array.array))
        kind = "a list of one of the allowed types" if many else "one of the allowed types"
        items = [value, *value] if isinstance(value, (list, tuple)) else [value]
        is_numpy = any(callable(getattr(item, "tolist", None)) for item in items)
        advice = "; write .tolist() after a value of numpy" if is_numpy else ""
        super().__init__(
            f"The given value is not {kind} '{value}': a parameter is a bool, an int, a float, "
            f"a str, or a list of one of these{advice}"
        )


class ParameterMismatchError(ZbotError, ValueError):
    """A parameter's type and the type of its value differ."""

    def __init__(self, name: str, type_: Parameter.Type, value: object) -> None:
        self.name, self.type_, self.value = name, type_, value
        super().__init__(f"parameter {name!r}: type {type_.name} and value {value!r} do not agree")


class InvalidParameterTypeException(ParameterError, TypeError):  # noqa: N818 - rclpy's name
    """A parameter's value has another type than the declaration. The value is often an override."""

    def __init__(self, desired_parameter: Parameter[Any], expected_type: str) -> None:
        self.desired_parameter, self.expected_type = desired_parameter, expected_type
        super().__init__(
            f"Trying to set parameter {desired_parameter.name!r} to "
            f"'{desired_parameter.value}' of type '{desired_parameter.type_.name}', "
            f"expecting type '{expected_type}'"
            f"{advice_for_override(desired_parameter.value, expected_type)}",
            desired_parameter.name,
        )


class UnknownParameterTypeError(ZbotError, RuntimeError):
    """A message has an unknown parameter type."""

    def __init__(self, type_: int) -> None:
        self.type_ = type_
        super().__init__(f"unexpected parameter type {type_}: use 0 to {max(Parameter.Type)}")


def no_parameters_error(path: str, nodes: Sequence[str]) -> WrongStateError:
    """Return the error that a parameter file has no parameters for the given nodes."""
    of = f" for {', '.join(nodes)}" if nodes else ""
    return WrongStateError(f"Param file does not contain any valid parameters{of}: {path}")


class Parameter(Generic[ValueT_co]):
    """A named value with a type, as in rclpy.

    Integers become floats if the type is DOUBLE or DOUBLE_ARRAY.

    Args:
        name: The name. Dots separate groups.
        type_: The type. By default, it is the type of the value.
        value: The value. `AllowableParameterValue` lists the possible types.

    Raises:
        ParameterTypeError: No parameter can have such a value.
        ParameterMismatchError: The value has another type.
        ArgumentTypeError: `type_` is not a `Parameter.Type`.
    """

    _zbot_stands_for = "rcl_interfaces/msg/Parameter"  # message fields accept this class too

    class Type(IntEnum):
        """The types, with the numbers of rcl_interfaces/msg/ParameterType."""

        NOT_SET = 0
        BOOL = 1
        INTEGER = 2
        DOUBLE = 3
        STRING = 4
        BYTE_ARRAY = 5
        BOOL_ARRAY = 6
        INTEGER_ARRAY = 7
        DOUBLE_ARRAY = 8
        STRING_ARRAY = 9

        @classmethod
        def from_parameter_value(cls, parameter_value: Any) -> Parameter.Type:
            """Return the type of a value.

            Raises:
                ParameterTypeError: No parameter can have such a value.
            """
            if parameter_value is None:
                return cls.NOT_SET
            for python_type, found in _SCALARS:
                if isinstance(parameter_value, python_type):
                    return cls(found)
            if isinstance(parameter_value, (list, tuple, array.array)):
                for found in _ARRAYS:
                    if all(_is_a(item, found) for item in parameter_value):
                        return cls(found)
                if all(map(_is_number, parameter_value)):
                    return cls.DOUBLE_ARRAY
            raise ParameterTypeError(parameter_value)

        def check(self, parameter_value: Any) -> bool:
            """Return whether a value has this type. An int does not count as DOUBLE here."""
            if self is Parameter.Type.NOT_SET:
                return parameter_value is None
            if not self.is_array:
                return _is_a(parameter_value, self)
            return isinstance(parameter_value, (list, tuple, array.array)) and all(
                _is_a(item, self) for item in parameter_value
            )

        @property
        def is_array(self) -> bool:
            """Whether the values are lists."""
            return self >= Parameter.Type.BYTE_ARRAY

        @property
        def text(self) -> str:
            """The type as the command line prints it, e.g. `double array`."""
            words = {"NOT_SET": "not set", "BOOL": "boolean", "BOOL_ARRAY": "boolean array"}
            return words.get(self.name, self.name.lower().replace("_", " "))

    @overload
    def __init__(self: Parameter[Any], name: str, type_: Parameter.Type | None = None) -> None: ...
    @overload
    def __init__(
        self, name: str, type_: Parameter.Type | None = None, *, value: ValueT_co
    ) -> None: ...
    @overload
    def __init__(self, name: str, type_: Parameter.Type | None, value: ValueT_co) -> None: ...
    def __init__(self, name: str, type_: Parameter.Type | None = None, value: Any = None) -> None:
        if type_ is None:
            type_ = Parameter.Type.from_parameter_value(value)
        elif not isinstance(type_, Parameter.Type):
            raise ArgumentTypeError("type_", "a Parameter.Type", type_)
        value = _widened(type_, value)
        if not type_.check(value):
            raise ParameterMismatchError(name, type_, value)
        self._name = name
        self._type_ = type_
        self._value = value

    @classmethod
    def from_parameter_msg(cls, param_msg: ParameterMsg) -> Parameter[Any]:
        """Return the parameter that an rcl_interfaces/msg/Parameter describes."""
        value = parameter_value_to_python(param_msg.value)
        return Parameter(param_msg.name, Parameter.Type(param_msg.value.type), value)

    @property
    def name(self) -> str:
        """The full name within its node."""
        return self._name

    @property
    def type_(self) -> Parameter.Type:
        """The type."""
        return self._type_

    @property
    def value(self) -> ValueT_co:
        """The value. It is None if the type is NOT_SET."""
        return cast("ValueT_co", self._value)

    def get_parameter_value(self) -> ParameterValue:
        """Return the value as a message, which has one field for each type.

        A warning tells of a program whose line reads the field of another type.
        """
        from rcl_interfaces.msg import ParameterValue  # noqa: PLC0415 - the import makes the class

        message = ParameterValue(type=int(self._type_))
        if self._type_ is not Parameter.Type.NOT_SET:
            value = list(self._value) if self._type_.is_array else self._value
            setattr(message, _field(self._type_), value)
            self._check_field(field_read_from("get_parameter_value"))
        return message

    def _check_field(self, read: str) -> None:
        field = _field(self._type_)
        if read != field and read in _FIELDS:
            warnings.warn(
                f"the value of the parameter {self._name} is not in {read}, but in {field}, "
                f"because it is {self._value!r}: write get_parameter({self._name!r}).value",
                stacklevel=3,
            )

    def to_parameter_msg(self) -> ParameterMsg:
        """Return the parameter as a message."""
        from rcl_interfaces.msg import Parameter as Message  # noqa: PLC0415 - the import makes the class

        return Message(name=self._name, value=self.get_parameter_value())

    __hash__ = object.__hash__

    def __eq__(self, other: object) -> bool:
        """Return whether this is the same object. A comparison with a value is a mistake."""
        if isinstance(other, (str, int, float)):
            warnings.warn(
                f"the parameter {self._name} is compared with {other!r}, and they always differ: "
                f"compare its value, e.g. get_parameter({self._name!r}).value == {other!r}",
                stacklevel=2,
            )
        return self is other

    def __bool__(self) -> bool:
        """Return `True`, as for each object. If the value is `False`, this is a mistake."""
        if self._value is False:
            warnings.warn(
                f"a condition takes the parameter {self._name} as true, but its value is False: "
                f"write get_parameter({self._name!r}).value",
                stacklevel=2,
            )
        return True

    def __repr__(self) -> str:
        return f"Parameter({self._name!r}, {self._type_!s}, {self._value!r})"


# The order matters: bool is a subclass of int. An empty list is a BYTE_ARRAY, as in rclpy.
_SCALARS: tuple[tuple[type[Any], int], ...] = ((bool, 1), (int, 2), (float, 3), (str, 4))
_ARRAYS = (5, 6, 7, 8, 9)
_ELEMENTS: dict[int, type[Any]] = {
    Parameter.Type.BOOL: bool,
    Parameter.Type.INTEGER: int,
    Parameter.Type.DOUBLE: float,
    Parameter.Type.STRING: str,
    Parameter.Type.BYTE_ARRAY: bytes,
    Parameter.Type.BOOL_ARRAY: bool,
    Parameter.Type.INTEGER_ARRAY: int,
    Parameter.Type.DOUBLE_ARRAY: float,
    Parameter.Type.STRING_ARRAY: str,
}


def _is_a(value: Any, type_: int) -> bool:
    """Return whether a value is a scalar of a type, or can be an element of an array type."""
    if not isinstance(value, _ELEMENTS[type_]):
        return False
    if _ELEMENTS[type_] is int:
        return not isinstance(value, bool) and value in _INT64
    return len(value) == 1 if isinstance(value, bytes) else True


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _widened(type_: Parameter.Type, value: Any) -> Any:
    try:
        if type_ is Parameter.Type.DOUBLE and type(value) is int:
            return float(value)
        if type_ is Parameter.Type.DOUBLE_ARRAY and isinstance(value, (list, tuple)):
            is_mixed = any(type(item) is int for item in value) and all(map(_is_number, value))
            return [float(item) for item in value] if is_mixed else value
    except OverflowError:
        return value  # too large for a float: a later check rejects the integer
    return value


def _field(type_: Parameter.Type) -> str:
    return f"{type_.name.lower()}_value"


_FIELDS = frozenset(map(_field, Parameter.Type))


def parameter_value_to_python(parameter_value: ParameterValue) -> AllowableParameterValue:
    """Return the value of an rcl_interfaces/msg/ParameterValue, or None if the type is NOT_SET.

    Raises:
        UnknownParameterTypeError: The message has an unknown type.
    """
    type_ = parameter_type(parameter_value.type)
    if type_ is Parameter.Type.NOT_SET:
        return None
    value = getattr(parameter_value, _field(type_))
    return list(value) if type_.is_array else value


def parameter_type(number: int) -> Parameter.Type:
    """Return the type that has this number in rcl_interfaces/msg/ParameterType.

    Raises:
        UnknownParameterTypeError: There is no such type.
    """
    try:
        return Parameter.Type(number)
    except ValueError:
        raise UnknownParameterTypeError(number) from None


def get_parameter_value(string_value: str) -> ParameterValue:
    """Return the message for a value that a user wrote, e.g. for `zbot param set`.

    The text is read as YAML: `true`, `5`, `5.0`, `[1, 2]`, `[a, b]`. A list of integers and floats
    is a list of doubles. `1e3` is a double too. Every other text is a string, also `y` and `nan`,
    which are not strings in parameter files.
    """
    try:
        value = _guessed(read_yaml(string_value), parse_value(string_value))
    except (YamlError, ParameterValueError):
        value = string_value
    return infer_parameter("", value, string_value).get_parameter_value()


def _guessed(by_yaml: Any, by_ros: Any) -> Any:
    """Return a value by YAML's rules, but by ROS 2's rules if the text is like `1e3` or `1:30`."""
    if isinstance(by_ros, list):
        return [_guessed(*pair) for pair in zip(by_yaml, by_ros, strict=True)]
    if isinstance(by_yaml, str):
        return by_ros if _EXPONENT.fullmatch(by_yaml) else by_yaml
    is_number = isinstance(by_yaml, (bool, int, float))
    return by_yaml if is_number and ":" not in str(by_ros) else by_ros


def infer_parameter(name: str, value: Any, text: str | None = None) -> Parameter[Any]:
    """Return a parameter with a value read from YAML.

    A list of several types, and an integer that does not fit into 64 bits, become a string.

    Args:
        name: The parameter's name.
        value: A scalar or a list of scalars.
        text: The YAML text of the value, for a value that becomes a string. Without `text`, the
            string is `str(value)`.
    """
    try:
        return Parameter(name, value=value)
    except (ParameterTypeError, ParameterMismatchError):
        return Parameter(name, value=str(value) if text is None else text)


def parameter_dict_from_yaml_file(
    parameter_file: str,
    use_wildcard: bool = False,
    target_nodes: list[str] | None = None,
    namespace: str = "",
) -> dict[str, ParameterMsg]:
    """Return the parameters that a file has for some nodes, by parameter name.

    Args:
        parameter_file: Path of the YAML file.
        use_wildcard: Whether to include `/**`. Parameters under a node's own name have priority.
        target_nodes: Names of the nodes, with or without the leading slash.
        namespace: Prefix that is added to each parameter's name without a separator.

    Raises:
        ParametersFileError: The file cannot be read, or does not have ROS 2's format. The error is
            also a `FileNotFoundError` if the file does not exist.
        WrongStateError: The file has no parameters for these nodes.
    """
    nodes = [name if name.startswith("/") else f"/{name}" for name in target_nodes or ()]
    found = sections(parameter_file)
    general = [values for pattern, values in found if use_wildcard and pattern == "/**"]
    own = [values for pattern, values in found if _is_for(pattern, nodes)]
    values = {name: value for group in (*general, *own) for name, value in group.items()}
    if not values:
        raise no_parameters_error(parameter_file, nodes)
    return {
        namespace + name: infer_parameter(namespace + name, value).to_parameter_msg()
        for name, value in values.items()
    }


def _is_for(pattern: str, nodes: Sequence[str]) -> bool:
    return "*" not in pattern and any(matches(pattern, node) for node in nodes)
