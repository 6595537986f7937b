"""Message values on the command line: YAML, JSON, or words like `linear.x=2`."""

from __future__ import annotations

import base64
import binascii
import itertools
import re
import sys
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Union

from zbot.errors import ZbotError
from zbot.errors.suggestion import did_you_mean
from zbot.interfaces import get_message, spec_of, yaml_text
from zbot.terminal.typographic import is_quoted
from zbot_cli.input import yaml_mistakes

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from zbot.interfaces import FieldType

_ASSIGNMENT = re.compile(r"(?P<path>[A-Za-z_]\w*(\.\w+)*)=(?P<value>.*)\Z", re.DOTALL)
_SEPARATOR = re.compile(r"^---[ \t]*$", re.MULTILINE)
_HEADER = "std_msgs/msg/Header"
_TIME = "builtin_interfaces/msg/Time"
_OCTETS = {"byte", "char", "uint8"}
_LONGEST_SHOWN_LINE = 200


class ValuesError(ZbotError):
    """The values on a command line are not YAML, or not a dictionary."""

    def __init__(self, text: str, hint: str | None = None) -> None:
        super().__init__(text, hint=hint)


class PopulateError(ZbotError):
    """A value does not fit the message."""

    def __init__(self, reason: str, hint: str | None = None) -> None:
        super().__init__(f"Failed to populate field: {reason}", hint=hint)


@dataclass(frozen=True)
class Word:
    """Scalar: a single value, not a list or a dictionary."""

    text: str  #: as the user wrote it: `yes`, `1.0`
    value: Any  #: as YAML reads it: True, 1.0

    def __str__(self) -> str:
        return self.text


class _Key(str):
    """Name of a field, with its line and column in the text."""

    __slots__ = ("place",)
    place: str


#: Values as they were read from text, before they are fitted to a message type.
Tree = Union[Word, "list[Tree]", "dict[str, Tree]"]


class Template:
    """Maker of messages of one type from the values of a command line.

    The constructor reports values that do not fit, before the command waits for nodes.

    Args:
        message_type: Message class.
        words: YAML (which includes JSON), or words like `linear.x=2 angular.z=1.8`. Without words,
            all fields keep their defaults.

    Raises:
        ValuesError: The words are not a dictionary in YAML.
        PopulateError: A field does not exist, or a value does not fit its field.
    """

    def __init__(self, message_type: type[Any], words: str | Sequence[str]) -> None:
        self._type = message_type
        self._values = parse(words, message_type.get_fields_and_field_types())
        #: Whether a message contains the current time. If so, each publication needs a new message.
        self.is_stamped = False
        self.make(self._note_time_use)
        _note_quotes(self._values)

    def make(self, now_ns: Callable[[], int]) -> Any:
        """Return a message.

        Args:
            now_ns: Function that gives the time for `header: auto` and `stamp: now`, in nanoseconds
                since the epoch.
        """
        message = self._type()
        _fill(message, self._values, now_ns, "")
        return message

    def _note_time_use(self) -> int:
        self.is_stamped = True
        return 0


def split_documents(text: str) -> list[str]:
    """Return the documents of a YAML stream, such as saved output of `zbot topic echo`."""
    return [part for part in _SEPARATOR.split(text) if part.strip()]


def _note_quotes(tree: Tree) -> None:
    """Say that quotes of a word processor are a part of the first text that has them."""
    if isinstance(tree, Word):
        text = tree.text
        if is_quoted(text):
            quotes = f"type ' in place of {text[0]} and {text[-1]} if they are not a part of it"
            print(f"note: the text is {text}: {quotes}", file=sys.stderr)
        return
    for inner in tree.values() if isinstance(tree, dict) else tree:
        _note_quotes(inner)


# -- from text to a tree -----------------------------------------------------------------------


def parse(words: str | Sequence[str], fields: Iterable[str] = ()) -> dict[str, Tree]:
    """Return the dictionary that a string or the words of a command line contain.

    Args:
        words: The string, or the words.
        fields: The fields of the message, for the hint of an error.

    Raises:
        ValuesError: The words contain no dictionary.
    """
    words = [words] if isinstance(words, str) else list(words)
    if len(words) == 1 and all(map(_ASSIGNMENT.match, words[0].split())):
        words = words[0].split()
    matches = [match for match in map(_ASSIGNMENT.match, words) if match]
    if matches and len(matches) == len(words):
        return _assignments(matches)
    text = " ".join(words)
    tree = _parsed(text)
    if tree is None:
        return {}
    if not isinstance(tree, dict):
        raise ValuesError(
            "The passed value needs to be a dictionary in YAML format", _advice(text, fields)
        )
    return tree


def _advice(text: str, fields: Iterable[str]) -> str:
    name, colon, value = text.strip().partition(":")
    if colon and name.isidentifier():
        return f"put a blank after the colon: '{name}: {value.strip()}'"
    example = ", ".join(f"{field}: ..." for field in fields) or "data: hello"
    return f'name the fields that the values are for: "{{{example}}}"'


def _parsed(text: str) -> Tree | None:
    try:
        node = yaml_text.compose(text)
        return None if node is None or _is_empty(node) else _tree(node, text)
    except yaml_text.YamlError as exc:
        raise _syntax_error(text, exc) from None


def _is_empty(node: yaml_text.Node) -> bool:
    return isinstance(node, yaml_text.ScalarNode) and node.tag == "tag:yaml.org,2002:null"


def _tree(node: yaml_text.Node, text: str) -> Tree:
    if isinstance(node, yaml_text.SequenceNode):
        return [_tree(item, text) for item in node.value]
    if isinstance(node, yaml_text.MappingNode):
        return _mapping(node, text)
    assert isinstance(node, yaml_text.ScalarNode)
    return Word(node.value, yaml_text.scalar(node))


def _mapping(node: yaml_text.MappingNode, text: str) -> dict[str, Tree]:
    tree: dict[str, Tree] = {}
    for before, (key_node, _) in itertools.pairwise(node.value):
        if mistake := yaml_mistakes.stray_comma(before, key_node, text):
            raise ValuesError(mistake[0] + _place(text, key_node.start_mark), mistake[1])
    for key_node, value_node in node.value:
        key = _Key(key_node.value)
        key.place = _place(text, key_node.start_mark)
        if key in tree:
            raise ValuesError(f"{key} has two values{key.place}", "leave one of them out")
        tree[key] = _tree(value_node, text)
    return tree


def _assignments(matches: list[re.Match[str]]) -> dict[str, Tree]:
    tree: dict[str, Tree] = {}
    for match in matches:
        *path, last = match["path"].split(".")
        place = tree
        for name in path:
            inner = place.setdefault(name, {})
            if not isinstance(inner, dict):
                raise ValuesError(f"{name} has two values, one of them in '{match[0]}'")
            place = inner
        if last in place:
            raise ValuesError(f"{match['path']} has two values")
        place[last] = _assigned(match["value"])
    return tree


def _assigned(text: str) -> Tree:
    try:
        node = yaml_text.compose(text)
        if node is None:
            return Word("", None)
        # A list or dictionary needs brackets. The text `a: b` is a string: the user typed
        # `data="a: b"`, and the shell removed the quotes.
        if not isinstance(node, yaml_text.CollectionNode) or node.flow_style:
            return _tree(node, text)
    except yaml_text.YamlError:
        pass
    return Word(text, text)


def _syntax_error(text: str, exc: yaml_text.YamlError) -> ValuesError:
    place = "" if exc.line is None else _place(text, exc)
    hint = yaml_mistakes.syntax_hint(text, exc)
    return ValuesError(f"The values are not YAML: {exc.problem}{place}", hint)


def _place(text: str, mark: Any) -> str:
    """Return the line and column of a mark, and the text of this line with `^` below the column."""
    if mark is None:
        return ""
    lines = text.splitlines() or [""]
    line, column = mark.line, mark.column
    if line >= len(lines):  # YAML counts the end of a text as one more line
        line, column = len(lines) - 1, len(lines[-1])
    place = f" (line {line + 1}, column {column + 1})"
    if len(lines[line]) > _LONGEST_SHOWN_LINE:
        return place
    return f"{place}\n  {lines[line]}\n  {' ' * column}^"


# -- from a tree to a message ------------------------------------------------------------------


def _fill(message: Any, values: dict[str, Tree], now_ns: Callable[[], int], path: str) -> None:
    kinds: dict[str, FieldType] = {
        field.name: field.type
        for field in spec_of(type(message)).fields  # type: ignore[union-attr]
    }
    for name, value in values.items():
        if name not in kinds:
            raise _unknown_field(message, name, value, list(kinds))
        try:
            setattr(message, name, _value(kinds[name], value, now_ns, f"{path}{name}"))
        except (TypeError, ValueError, OverflowError) as exc:
            raise PopulateError(str(exc), _example(kinds[name], f"{path}{name}")) from None


def _unknown_field(message: Any, name: str, value: Tree, known: list[str]) -> PopulateError:
    reason = f"'{type(message).__name__}' object has no attribute '{name}'"
    has_no_value = isinstance(value, Word) and value.value is None
    if has_no_value and (hint := yaml_mistakes.wrong_colon(name)):
        return PopulateError(reason + getattr(name, "place", ""), hint)
    fields = f"its fields are {', '.join(known)}" if known else "it has no fields"
    return PopulateError(reason, did_you_mean(name, known) or fields)


def _example(kind: FieldType, path: str) -> str | None:
    name = path.rpartition(".")[2]
    if kind.kind != "scalar":
        return f"{path} is {kind.text}: write {name}: [...]"
    number = "1.5" if kind.base.startswith("float") else "2"
    if not kind.typecode:
        return None
    article = "an" if kind.base.startswith("i") else "a"
    return f"{path} is {article} {kind.base}: write {name}: {number}"


def _value(kind: FieldType, value: Tree, now_ns: Callable[[], int], path: str) -> Any:
    if kind.kind != "scalar":
        return _list(kind, value, now_ns, path)
    if kind.is_message:
        return _nested(kind, value, now_ns, path)
    if not isinstance(value, Word):
        many = "a dictionary" if isinstance(value, dict) else "a list"
        hint = f"put the text of {path} in quotes" if kind.is_string else _example(kind, path)
        raise PopulateError(f"{path} is a {kind.base}, not {many}", hint)
    return _scalar(kind, value, path)


def _list(kind: FieldType, value: Tree, now_ns: Callable[[], int], path: str) -> list[Any] | bytes:
    one = type(kind)(kind.base, "scalar", 0, kind.string_bound)
    if isinstance(value, list):
        return [_value(one, item, now_ns, f"{path}[{index}]") for index, item in enumerate(value)]
    if isinstance(value, Word) and value.value is None:
        return []
    if isinstance(value, Word) and kind.base in _OCTETS:
        return _octets(kind, value, path)
    hint = (
        f"write {path.rpartition('.')[2]}: [{_shown(value)}]" if isinstance(value, Word) else None
    )
    raise PopulateError(f"{path} is {kind.text}: give it a list, not {_shown(value)}", hint)


def _octets(kind: FieldType, value: Word, path: str) -> list[Any] | bytes:
    """Return the bytes of a base64 string. `zbot topic echo --json` prints bytes in this form."""
    try:
        octets = base64.b64decode(value.text, validate=True)
    except (binascii.Error, ValueError):
        raise PopulateError(
            f"{path} is {kind.text}: give it a list or base64, not {_shown(value)}"
        ) from None
    return [bytes([octet]) for octet in octets] if kind.base == "byte" else octets


def _nested(kind: FieldType, value: Tree, now_ns: Callable[[], int], path: str) -> Any:
    message: Any = get_message(kind.base)()
    word = value.text if isinstance(value, Word) else None
    if (kind.base, word) == (_HEADER, "auto"):
        value = {"stamp": Word("now", "now")}
    if (kind.base, word) == (_TIME, "now"):
        message.sec, message.nanosec = divmod(now_ns(), 10**9)
        return message
    if not isinstance(value, dict):
        name = "list" if isinstance(value, list) else type(value.value).__name__
        raise PopulateError(
            f"Value '{_shown(value)}' is expected to be a dictionary but is a {name}",
            f"{path} is a {kind.base}: write {path.rpartition('.')[2]}: {{...}}",
        )
    _fill(message, value, now_ns, f"{path}.")
    return message


def _shown(value: Tree) -> str:
    if isinstance(value, Word):
        return value.text
    if isinstance(value, dict):
        return "{...}"
    return f"[{', '.join(map(_shown, value))}]"


def _scalar(kind: FieldType, word: Word, path: str) -> Any:
    if kind.is_string:
        # Use the text itself, because YAML reads 12:30 as the number 750, and `no` as False.
        return "" if word.value is None else word.text
    if kind.base == "bool":
        if isinstance(word.value, (bool, int)) and word.value in {0, 1}:
            return bool(word.value)
        raise PopulateError(f"{path} is a bool: give it true or false, not {word.text!r}")
    if word.value is None or isinstance(word.value, bool):
        found = "nothing" if word.value is None else word.text
        raise PopulateError(f"{path} is a number, not {found}", _example(kind, path))
    try:
        number: Any = (
            float(word.value) if kind.base.startswith("float") else _integer(kind, word.value, path)
        )
    except (ValueError, OverflowError):
        text = f"{path} is a number ({kind.base}), not {word.text!r}"
        name = path.rpartition(".")[2]
        hint = yaml_mistakes.number_with_comma(name, word.text) or _example(kind, path)
        raise PopulateError(text, hint) from None
    return bytes([number]) if kind.base == "byte" else number


def _integer(kind: FieldType, value: Any, path: str) -> int:
    if isinstance(value, float) and not value.is_integer():
        raise PopulateError(f"{path} is a whole number, not {value!r}", _example(kind, path))
    return int(value)
