"""Contents of .msg, .srv and .action files, with the names of ROS 2's `rosidl_adapter.parser`."""

from __future__ import annotations

import re
import textwrap
from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from zbot.errors import ArgumentTypeError, ZbotError
from zbot.interfaces import grammar, parser, spec
from zbot.interfaces.errors import InterfaceSyntaxError
from zbot.interfaces.grammar import GrammarError
from zbot.interfaces.literal import parse_value

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from os import PathLike

PRIMITIVE_TYPES: Final = list(spec.PRIMITIVES)
ACTION_REQUEST_RESPONSE_SEPARATOR = SERVICE_REQUEST_RESPONSE_SEPARATOR = "---"
ARRAY_UPPER_BOUND_TOKEN = STRING_UPPER_BOUND_TOKEN = "<="  # noqa: S105 - no password
COMMENT_DELIMITER, CONSTANT_SEPARATOR, PACKAGE_NAME_MESSAGE_TYPE_SEPARATOR = "#", "=", "/"
SERVICE_EVENT_MESSAGE_SUFFIX = "_Event"
SERVICE_REQUEST_MESSAGE_SUFFIX, SERVICE_RESPONSE_MESSAGE_SUFFIX = "_Request", "_Response"
ACTION_GOAL_SUFFIX, ACTION_RESULT_SUFFIX, ACTION_FEEDBACK_SUFFIX = "_Goal", "_Result", "_Feedback"
_NAME = re.compile(r"\s*\S+\s+(\w+)")
_UNIT = re.compile(r"(?<!\s)\s*\[([^,\]]{1,100})\]")


class InvalidSpecification(ZbotError):  # noqa: N818 - rosidl_adapter's name, as those below
    """A definition is invalid."""


class InvalidServiceSpecification(InvalidSpecification):
    """The definition of a service is invalid."""


class InvalidActionSpecification(InvalidSpecification):
    """The definition of an action is invalid."""


class InvalidFieldDefinition(InvalidSpecification):
    """A line of a definition is invalid."""


class InvalidResourceName(InvalidSpecification, TypeError, NameError):  # noqa: N818 - as above
    """The name of a type, field or constant is invalid."""

    def __init__(self, reason: str) -> None:
        super().__init__(reason)
        self.name = None  # so the traceback of this NameError does not suggest a similar variable


class UnknownMessageType(InvalidSpecification):
    """A field has a message type that is not among the known types."""


class InvalidLineError(InvalidFieldDefinition, InvalidResourceName, ValueError):
    """A line of a definition is invalid. rosidl_adapter raises one of the base classes."""


class InvalidValue(ZbotError, ValueError):  # noqa: N818 - as above
    """A value does not have the type of its field or constant."""

    def __init__(self, type_: object, value_string: str, message_suffix: str = "") -> None:
        suffix = f": {message_suffix}" if message_suffix else ""
        super().__init__(f"value {value_string!r} can not be converted to type '{type_}'{suffix}")


class BaseType:
    """Type of a single value.

    Args:
        type_string: A primitive type, `string<=N`, or the name of a message.
        context_package_name: The package of a message name without a package.

    Raises:
        InvalidResourceName: The text is not a type.
    """

    pkg_name: str | None  #: the message's package, or `None` for a primitive type
    type: str  #: `float64`, or the message's name without its package
    string_upper_bound: int | None  #: N of `string<=N`

    def __init__(self, type_string: str, context_package_name: str | None = None) -> None:
        kind = self._parsed(type_string, context_package_name)
        if kind.kind != "scalar":
            raise InvalidResourceName(f"{type_string!r} is an array: use the class Type for it")
        self._set_base(kind)

    @staticmethod
    def _parsed(text: str, package: str | None) -> spec.FieldType:
        try:
            kind = grammar.parse_type(text, package or "")
        except GrammarError as error:
            raise InvalidResourceName(str(error)) from None
        return kind

    def _set_base(self, kind: spec.FieldType) -> None:
        parts = kind.base.split("/")
        self.pkg_name = parts[0] if kind.is_message else None
        self.type = parts[-1]
        self.string_upper_bound = kind.string_bound or None

    def is_primitive_type(self) -> bool:
        """Return whether the type is not a message."""
        return self.pkg_name is None

    def __eq__(self, other: object) -> bool:
        return isinstance(other, BaseType) and str(self) == str(other)

    def __hash__(self) -> int:
        return hash(str(self))

    def __str__(self) -> str:
        bound = f"<={self.string_upper_bound}" if self.string_upper_bound else ""
        return f"{self.pkg_name}/{self.type}" if self.pkg_name else f"{self.type}{bound}"


class Type(BaseType):
    """Type of a field: a single value or an array. The arguments are those of `BaseType`."""

    is_array: bool  #: whether the type is an array, of any size
    array_size: int | None  #: N of `T[N]` or `T[<=N]`
    is_upper_bound: bool  #: whether the array may be shorter, as in `T[<=N]`

    def __init__(self, type_string: str, context_package_name: str | None = None) -> None:
        self._kind = kind = self._parsed(type_string, context_package_name)
        self._set_base(kind)
        self.is_array = kind.kind != "scalar"
        self.array_size = kind.size or None
        self.is_upper_bound = kind.kind == "sequence" and bool(kind.size)

    def is_dynamic_array(self) -> bool:
        """Return whether arrays of the type can have different sizes."""
        return self._kind.kind == "sequence"

    def is_fixed_size_array(self) -> bool:
        """Return whether all arrays of the type have the same size."""
        return self._kind.kind == "array"

    def parse(self, text: str) -> Any:
        """Return the value of a text. Raise `InvalidValue` if the text has another type."""
        if not isinstance(text, str):
            raise InvalidValue(self, text, "it is not a str")
        try:
            return _plain(parse_value(self._kind, text))
        except GrammarError as error:
            raise InvalidValue(self, text, str(error)) from None

    def __str__(self) -> str:
        bound = "<=" if self.is_upper_bound else ""
        return super().__str__() + (f"[{bound}{self.array_size or ''}]" if self.is_array else "")


def parse_value_string(type_: Type, value_string: str) -> Any:
    """Return the value of a text.

    Raises:
        InvalidValue: The text has another type.
        NotImplementedError: The type is a message.
    """
    if not type_.is_primitive_type():
        raise NotImplementedError(f"a text cannot have the type {type_}, which is a message")
    return type_.parse(value_string)


def _plain(value: Any) -> Any:
    if isinstance(value, tuple):
        return [_plain(item) for item in value]
    return value[0] if isinstance(value, bytes) else value


class _Declared:
    """Base of the parts of a definition. Parts can be compared. Their comments do not count."""

    #: `comment` has a list of lines. `unit` has the text between brackets, e.g. of `[m/s]`.
    annotations: dict[str, Any]

    def __eq__(self, other: object) -> bool:
        return type(other) is type(self) and self._contents() == other._contents()

    __hash__ = None  # type: ignore[assignment]  # the contents can change

    def _contents(self) -> dict[str, Any]:
        return {name: value for name, value in vars(self).items() if name != "annotations"}


class Constant(_Declared):
    """A constant. The arguments are its type, its name and the text of its value."""

    def __init__(self, primitive_type: str, name: str, value_string: str) -> None:
        if primitive_type not in PRIMITIVE_TYPES:
            raise ArgumentTypeError("primitive_type", "a primitive type", primitive_type)
        _check(grammar.check_constant_name, name, value_string)
        self.type, self.name = primitive_type, name
        self.value = Type(primitive_type).parse(value_string)
        self.annotations = {}

    def __str__(self) -> str:
        text = repr(self.value) if self.type in spec.STRING_TYPES else self.value
        return f"{self.type} {self.name}={text}"


class Field(_Declared):
    """A field. The arguments are its type, its name and the text of its default value."""

    def __init__(self, type_: Type, name: str, default_value_string: str | None = None) -> None:
        if not isinstance(type_, Type):
            raise ArgumentTypeError("type_", "a Type", type_)
        _check(grammar.check_field_name, name)
        self.type, self.name = type_, name
        text = default_value_string
        self.default_value = None if text is None else type_.parse(text)
        self.annotations = {}

    def __str__(self) -> str:
        value = self.default_value
        text = repr(value) if isinstance(value, str) else value
        return f"{self.type} {self.name}" + ("" if value is None else f" {text}")


class MessageSpecification(_Declared):
    """A message. The arguments are its package, its name, its fields and its constants.

    Raises:
        ArgumentTypeError: An item is not a field or a constant.
        ValueError: Two fields or two constants have the same name.
    """

    def __init__(
        self, pkg_name: str, msg_name: str, fields: Iterable[Field], constants: Iterable[Constant]
    ) -> None:
        self.base_type = BaseType(f"{pkg_name}/{msg_name}")
        self.msg_name = msg_name
        self.fields, self.constants = list(fields), list(constants)
        for declared, kind in ((self.fields, Field), (self.constants, Constant)):
            for item in declared:
                if not isinstance(item, kind):
                    raise ArgumentTypeError("an item", f"a {kind.__name__}", item)
            names = Counter(item.name for item in declared)
            twice = sorted(name for name, count in names.items() if count > 1)
            if twice:
                raise ValueError(f"{self.base_type} has more than one {', '.join(twice)}")
        self.annotations = {}

    def __str__(self) -> str:
        return "\n".join(map(str, (f"# {self.base_type}", *self.constants, *self.fields)))


class ServiceSpecification(_Declared):
    """A service. The arguments are its package, its name and its two messages."""

    def __init__(
        self,
        pkg_name: str,
        srv_name: str,
        request: MessageSpecification,
        response: MessageSpecification,
    ) -> None:
        self.pkg_name, self.srv_name = pkg_name, srv_name
        self.request, self.response = request, response
        self.annotations = {}

    def __str__(self) -> str:
        return f"# {self.pkg_name}/{self.srv_name}\n{self.request}\n---\n{self.response}"


class ActionSpecification(_Declared):
    """An action. The arguments are its package, its name and its three messages."""

    def __init__(
        self,
        pkg_name: str,
        action_name: str,
        goal: MessageSpecification,
        result: MessageSpecification,
        feedback: MessageSpecification,
    ) -> None:
        self.pkg_name, self.action_name = pkg_name, action_name
        self.goal, self.result, self.feedback = goal, result, feedback
        self.annotations = {}


def _check(check: Callable[..., None], *arguments: str) -> None:
    try:
        check(*arguments)
    except GrammarError as error:
        raise InvalidResourceName(str(error)) from None


def parse_message_string(pkg_name: str, msg_name: str, message_string: str) -> MessageSpecification:
    """Return the contents of the text of a .msg file.

    Raises:
        InvalidLineError: A line is invalid. The error has the line and advice.
    """
    try:
        parsed = parser.parse_message(f"{pkg_name}/msg/{msg_name}", message_string)
    except InterfaceSyntaxError as error:
        raise InvalidLineError(str(error)) from error
    return _message(parsed)


def parse_service_string(pkg_name: str, srv_name: str, message_string: str) -> ServiceSpecification:
    """Return the contents of the text of a .srv file.

    Raises:
        InvalidLineError: A line is invalid.
        InvalidServiceSpecification: The line `---` is missing.
    """
    try:
        parsed = parser.parse_service(f"{pkg_name}/srv/{srv_name}", message_string)
    except InterfaceSyntaxError as error:
        kind = InvalidLineError if error.line else InvalidServiceSpecification
        raise kind(str(error)) from error
    parts = map(_message, (parsed.request, parsed.response))
    return ServiceSpecification(pkg_name, srv_name, *parts)


def parse_action_string(pkg_name: str, action_name: str, action_string: str) -> ActionSpecification:
    """Return the contents of the text of a .action file.

    Raises:
        InvalidLineError: A line is invalid.
        InvalidActionSpecification: A line `---` is missing.
    """
    try:
        parsed = parser.parse_action(f"{pkg_name}/action/{action_name}", action_string)
    except InterfaceSyntaxError as error:
        kind = InvalidLineError if error.line else InvalidActionSpecification
        raise kind(str(error)) from error
    parts = map(_message, (parsed.goal, parsed.result, parsed.feedback))
    return ActionSpecification(pkg_name, action_name, *parts)


def parse_message_file(
    pkg_name: str, interface_filename: str | PathLike[str]
) -> MessageSpecification:
    """Return the contents of a .msg file. If it cannot be read, raise `OSError`."""
    return parse_message_string(pkg_name, *_name_and_text(interface_filename))


def parse_service_file(
    pkg_name: str, interface_filename: str | PathLike[str]
) -> ServiceSpecification:
    """Return the contents of a .srv file. If it cannot be read, raise `OSError`."""
    return parse_service_string(pkg_name, *_name_and_text(interface_filename))


def parse_action_file(
    pkg_name: str, interface_filename: str | PathLike[str]
) -> ActionSpecification:
    """Return the contents of a .action file. If it cannot be read, raise `OSError`."""
    return parse_action_string(pkg_name, *_name_and_text(interface_filename))


def validate_field_types(
    specification: MessageSpecification | ServiceSpecification | ActionSpecification,
    known_msg_types: Iterable[BaseType],
) -> None:
    """Check that the message types of all fields are known.

    Raises:
        UnknownMessageType: The type of a field is not among the known types.
    """
    parts = [specification, *vars(specification).values()]
    messages = [part for part in parts if isinstance(part, MessageSpecification)]
    known = set(map(str, known_msg_types))
    for field in (field for message in messages for field in message.fields):
        if not field.type.is_primitive_type() and BaseType.__str__(field.type) not in known:
            raise UnknownMessageType(f"the type of the field '{field}' is not known")


def _name_and_text(file: str | PathLike[str]) -> tuple[str, str]:
    path = Path(file)
    return path.stem, path.read_text(encoding="utf-8")


def _message(parsed: spec.MessageSpec) -> MessageSpecification:
    """Return a parsed message, with the comments of its lines."""
    package, _, name = parsed.name.split("/")
    declared: dict[str, Field | Constant] = {}
    for field in parsed.fields:
        declared[field.name] = made = Field(Type(field.type.text), field.name)
        made.default_value = None if field.default is None else _plain(field.default)
    for constant in parsed.constants:
        declared[constant.name] = other = Constant.__new__(Constant)
        other.type, other.name = constant.type.text, constant.name
        other.value, other.annotations = _plain(constant.value), {}
    fields = [item for item in declared.values() if isinstance(item, Field)]
    constants = [item for item in declared.values() if isinstance(item, Constant)]
    message = MessageSpecification(package, name, fields, constants)
    _annotate(message, declared, parsed.text)
    return message


def _annotate(
    message: MessageSpecification, declared: dict[str, Field | Constant], text: str
) -> None:
    """Give the message, fields and constants their comments.

    The comments of a line are above it, beside it, and indented below it. The message has the
    comments at the beginning of the text.
    """
    lines = text.splitlines()
    start = next((i for i, line in enumerate(lines) if not line.startswith("#")), len(lines))
    message.annotations = _annotations([line.lstrip("#") for line in lines[:start]])
    above: list[str] = []
    last: list[str] = []
    comments = {name: list[str]() for name in declared}
    for line in lines[start:]:
        code, comment = parser.split_comment(line)
        found = _NAME.match(code)
        if comment:
            (last if line[0].isspace() and not found else above).append(comment.lstrip("#"))
        if found:
            last = comments[found[1]]
            last += above
            above = []
    for name, about in comments.items():
        declared[name].annotations = _annotations(about)


def _annotations(lines: list[str]) -> dict[str, Any]:
    text = "\n".join(lines)
    units = _UNIT.findall(text)
    if len(units) == 1:
        text = _UNIT.sub("", text)
    text = re.sub(r"\n\n+", "\n\n", textwrap.dedent(text).strip("\n"))
    unit = {"unit": units[0]} if len(units) == 1 else {}
    return {"comment": text.split("\n") if text else [], **unit}
