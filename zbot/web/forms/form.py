"""Form for a message type. The form has an input for each field and creates the message.

This module works without a page. `form_view` shows the inputs in the page. An input converts the
text that the user typed, and `Input.problem` checks the text before a message is sent.
"""

from __future__ import annotations

import time
from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING, Any, TypeAlias

from zbot.interfaces import FieldType, get_message, spec_of
from zbot.interfaces.message_reader import FieldMisfitError
from zbot.web.forms.form_value import (
    DURATION,
    NOW,
    TIME,
    Entry,
    flow,
    integer_range,
    plain,
    read,
    show,
)

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping

__all__ = ["Entry", "Form", "Group", "Input", "InputKind"]

_HEADER = "std_msgs/msg/Header"


class InputKind(Enum):
    """Kind of an input."""

    BOOL = "bool"  #: the input is a checkbox
    INTEGER = "integer"
    NUMBER = "number"
    TEXT = "text"
    LIST = "list"  #: text in brackets: `[1, 2, 3]`
    TIME = "time"  #: seconds since the epoch, or `now`
    DURATION = "duration"  #: seconds


@dataclass(frozen=True, slots=True)
class Input:
    """Input of a form."""

    path: str  #: `linear.x`
    type: FieldType
    kind: InputKind
    default: str  #: the text before the user types

    @property
    def name(self) -> str:
        """The last part of the path."""
        return self.path.rpartition(".")[2]

    @property
    def bounds(self) -> tuple[int, int] | None:
        """The smallest and the largest value of an integer field, or None for other fields."""
        return integer_range(self.type.base) if self.kind is InputKind.INTEGER else None

    @property
    def max_length(self) -> int | None:
        """The largest length of a string or a list, or None if there is no limit."""
        bound = self.type.size if self.kind is InputKind.LIST else self.type.string_bound
        return bound or None

    def read(self, entry: Entry, now_ns: Callable[[], int] = time.time_ns) -> Any:
        """Return the field's value for an entry.

        Raises:
            FieldMisfitError: The entry does not fit the field.
        """
        return read(self.type, entry, self.path, now_ns)

    def has_now(self, entry: Entry) -> bool:
        """Return whether the value for an entry may depend on the time, e.g. for `now`."""
        return self.type.is_message and NOW in str(entry)


@dataclass(frozen=True, slots=True)
class Group:
    """Group of inputs for a field that is itself a message."""

    path: str
    type_name: str
    members: tuple[Input | Group, ...]

    @property
    def name(self) -> str:
        """The last part of the path."""
        return self.path.rpartition(".")[2]


Member: TypeAlias = "Input | Group"


class Form:
    """Form for messages of one type.

    Args:
        message_type: A message class, the `Request` of a service, or the `Goal` of an action.

    Attributes:
        members: Inputs and groups of inputs, in the order of the definition.
        inputs: All inputs, including the inputs in groups.
    """

    def __init__(self, message_type: type[Any]) -> None:
        self._type = message_type
        self.members = _members(message_type(), "", "")
        self.inputs = tuple(_inputs(self.members))
        # The last entry of each input with its value or error. Reading a long list takes 50 ms.
        self._known: dict[str, tuple[Entry, Any]] = {}

    def message(
        self, entries: Mapping[str, Entry], now_ns: Callable[[], int] = time.time_ns
    ) -> Any:
        """Return the message for the entries of all inputs.

        Args:
            entries: The entries by path. If an entry is missing, the input's default is used.
            now_ns: Function that returns the time for `now`, in nanoseconds since the epoch.

        Raises:
            FieldMisfitError: An entry does not fit its field.
        """
        message = self._type()
        for input_, entry in self._changed(entries):
            _set(message, input_.path, self._value(input_, entry, now_ns))
        return message

    def maker(
        self, entries: Mapping[str, Entry], now_ns: Callable[[], int] = time.time_ns
    ) -> Callable[[], Any]:
        """Return a quick function that returns the message for the entries of all inputs.

        The function always returns the same message, with the present time for `now`. Any thread
        may call it. The arguments are those of `message`.

        Raises:
            FieldMisfitError: An entry does not fit its field.
        """
        message = self.message(entries, now_ns)
        moving = [pair for pair in self._changed(entries) if pair[0].has_now(pair[1])]

        def make() -> Any:
            for input_, entry in moving:
                _set(message, input_.path, input_.read(entry, now_ns))
            return message

        return make

    def problem(self, input_: Input, entry: Entry) -> str | None:
        """Return a sentence about a wrong entry, or None if the entry is valid."""
        try:
            self._value(input_, entry)
        except FieldMisfitError as error:
            return error.sentence
        return None

    def problems(self, entries: Mapping[str, Entry]) -> dict[str, str]:
        """Return a sentence about each wrong entry, by path."""
        found = {
            input_.path: self.problem(input_, entry) for input_, entry in self._changed(entries)
        }
        return {path: problem for path, problem in found.items() if problem is not None}

    def _changed(self, entries: Mapping[str, Entry]) -> Iterator[tuple[Input, Entry]]:
        """Yield the inputs with another value than a new message, and their entries."""
        for input_ in self.inputs:
            entry = entries.get(input_.path, input_.default)
            if entry != input_.default or input_.has_now(entry):
                yield input_, entry

    def _value(self, input_: Input, entry: Entry, now_ns: Callable[[], int] = time.time_ns) -> Any:
        if input_.has_now(entry):
            return input_.read(entry, now_ns)
        known = self._known.get(input_.path)
        if known is None or known[0] != entry:
            known = self._known[input_.path] = entry, _value_or_error(input_, entry)
        if isinstance(known[1], FieldMisfitError):
            raise known[1].with_traceback(None)
        return known[1]

    def entries(self, message: Any) -> dict[str, str]:
        """Return the texts that the inputs show for a message, by path."""
        return {
            input_.path: show(input_.type, _follow(message, input_.path)) for input_ in self.inputs
        }

    def yaml(self, entries: Mapping[str, Entry]) -> str:
        """Return the message as YAML for a command line: `{linear: {x: 2.0}}`.

        The YAML leaves out each field that has its default value. The text `now` stays `now`.

        Raises:
            FieldMisfitError: An entry does not fit its field.
        """
        new, tree = self._type(), dict[str, Any]()
        for input_, entry in self._changed(entries):
            value, is_now = (
                self._value(input_, entry),
                input_.kind is InputKind.TIME and entry == NOW,
            )
            shown = NOW if is_now else plain(input_.type, value)
            if is_now or shown != plain(input_.type, _follow(new, input_.path)):
                _put(tree, input_.path, shown)
        return flow(tree)


def _follow(message: Any, path: str) -> Any:
    for name in path.split("."):
        message = getattr(message, name)
    return message


def _set(message: Any, path: str, value: Any) -> None:
    *names, last = path.split(".")
    for name in names:
        message = getattr(message, name)
    setattr(message, last, value)


def _value_or_error(input_: Input, entry: Entry) -> Any:
    try:
        return input_.read(entry)
    except FieldMisfitError as error:
        return error


def _put(tree: dict[str, Any], path: str, value: Any) -> None:
    *names, last = path.split(".")
    for name in names:
        tree = tree.setdefault(name, {})
    tree[last] = value


def _inputs(members: tuple[Member, ...]) -> Iterator[Input]:
    for member in members:
        if isinstance(member, Group):
            yield from _inputs(member.members)
        else:
            yield member


def _members(message: Any, prefix: str, type_name: str) -> tuple[Member, ...]:
    spec = spec_of(type(message))
    return tuple(
        _member(f"{prefix}{field.name}", field.type, getattr(message, field.name), type_name)
        for field in spec.fields  # type: ignore[union-attr]
    )


def _member(path: str, kind: FieldType, value: Any, inside: str) -> Member:
    is_group = kind.is_message and kind.kind == "scalar" and kind.base not in {TIME, DURATION}
    if is_group:
        message = value if value is not None else get_message(kind.base)()
        return Group(path, kind.base, _members(message, f"{path}.", kind.base))
    # At first the stamp of a header is `now`, because programs usually set it to the present time.
    is_stamp = kind.base == TIME and kind.kind == "scalar" and inside == _HEADER
    return Input(path, kind, _input_kind(kind), NOW if is_stamp else show(kind, value))


def _input_kind(kind: FieldType) -> InputKind:
    if kind.kind != "scalar":
        return InputKind.LIST
    if kind.base in {TIME, DURATION}:
        return InputKind.TIME if kind.base == TIME else InputKind.DURATION
    if kind.is_string:
        return InputKind.TEXT
    if kind.base == "bool":
        return InputKind.BOOL
    return InputKind.INTEGER if integer_range(kind.base) else InputKind.NUMBER
