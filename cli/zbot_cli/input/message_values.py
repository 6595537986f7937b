"""Message values on the command line: YAML, JSON, or words like `linear.x=2`."""

from __future__ import annotations

import itertools
import re
import sys
from functools import partial
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.interfaces import yaml_text
from zbot.interfaces.message_reader import FieldMisfitError
from zbot.interfaces.yaml_message import Key, Word, YamlReader, tree_of
from zbot.text.typographic import is_quoted
from zbot_cli.input import yaml_mistakes

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from zbot.interfaces.slot import Slot
    from zbot.interfaces.yaml_message import Tree

_ASSIGNMENT = re.compile(r"(?P<path>[A-Za-z_]\w*(\.\w+)*)=(?P<value>.*)\Z", re.DOTALL)
_SEPARATOR = re.compile(r"^---[ \t]*$", re.MULTILINE)
_HEADER = "std_msgs/msg/Header"
_TIME = "builtin_interfaces/msg/Time"
_LONGEST_SHOWN_LINE = 200
_MAX_LEVELS = 100  #: as in YAML


class ValuesError(ZbotError):
    """The values on a command line are not YAML, or not a dictionary."""

    def __init__(self, text: str, hint: str | None = None) -> None:
        super().__init__(text, hint=hint)


class PopulateError(ZbotError):
    """A value does not fit the message."""

    def __init__(self, reason: str, hint: str | None = None) -> None:
        super().__init__(f"Failed to populate field: {reason}", hint=hint)


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
        try:
            return _Reader(now_ns).message(self._type, self._values)
        except FieldMisfitError as error:
            raise PopulateError(str(error), error.hint) from None

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
    return tree_of(node, text, partial(_check_mapping, text))


def _check_mapping(text: str, node: yaml_text.MappingNode) -> None:
    for before, (key_node, _) in itertools.pairwise(node.value):
        if mistake := yaml_mistakes.stray_comma(before, key_node, text):
            raise ValuesError(mistake[0] + _place(text, key_node.start_mark), mistake[1])
    names: set[str] = set()
    for key_node, _ in node.value:
        name = str(key_node.value)
        if name in names:
            place = _place(text, key_node.start_mark)
            raise ValuesError(f"{name} has two values{place}", "leave one of them out")
        names.add(name)


def _assignments(matches: list[re.Match[str]]) -> dict[str, Tree]:
    tree: dict[str, Tree] = {}
    for match in matches:
        *path, last = match["path"].split(".")
        if len(path) > _MAX_LEVELS:
            raise ValuesError(f"a field is nested deeper than {_MAX_LEVELS} levels")
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


class _Reader(YamlReader):
    """Reader of a command line's values, with `header: auto` and `stamp: now`.

    Args:
        now_ns: Function that gives the current time in nanoseconds since the epoch.
    """

    def __init__(self, now_ns: Callable[[], int]) -> None:
        super().__init__()
        self._now_ns = now_ns

    def nested(self, slot: Slot, value: Any, path: str) -> Any:
        word = value.text if isinstance(value, Word) else None
        if (slot.type.base, word) == (_HEADER, "auto"):
            value = {"stamp": Word("now", "now")}
        if (slot.type.base, word) != (_TIME, "now"):
            return super().nested(slot, value, path)
        sec, nanosec = divmod(self._now_ns(), 10**9)
        return slot.message_type(sec=sec, nanosec=nanosec)

    def unknown_field(self, message: Any, name: str, value: Any, path: str) -> Exception:
        error = super().unknown_field(message, name, value, path)
        has_no_value = isinstance(value, Word) and value.value is None
        if has_no_value and (hint := yaml_mistakes.wrong_colon(name)):
            place = _place(name.text, name.mark) if isinstance(name, Key) else ""
            return FieldMisfitError(path, f"{error}{place}", hint)
        return error
