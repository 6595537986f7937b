"""Reader of messages from YAML, as users write it on a command line or into a form."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Union

from zbot.interfaces import yaml_text
from zbot.interfaces.message_reader import MessageReader, octets

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.interfaces.slot import Slot


@dataclass(frozen=True)
class Word:
    """Scalar: a single value, not a list or a dictionary."""

    text: str  #: as the user wrote it: `yes`, `1.0`
    value: Any  #: as YAML reads it: True, 1.0

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return self.text


class Key(str):
    """Name of a field, with its place in the text."""

    __slots__ = ("mark", "text")
    text: str  #: the whole text
    mark: Any  #: PyYAML's mark: line and column


#: Values as they were read from text, before they are fitted to a message type.
Tree = Union[Word, "list[Tree]", "dict[str, Tree]"]


def tree_of(
    node: yaml_text.Node,
    text: str,
    check: Callable[[yaml_text.MappingNode], None] | None = None,
) -> Tree:
    """Return the values of a YAML node.

    Args:
        node: The node.
        text: The text that the node was read from.
        check: Function that is called for each mapping, outermost first.
    """
    if isinstance(node, yaml_text.SequenceNode):
        return [tree_of(item, text, check) for item in node.value]
    if not isinstance(node, yaml_text.MappingNode):
        assert isinstance(node, yaml_text.ScalarNode)
        return Word(node.value, yaml_text.scalar(node))
    if check is not None:
        check(node)
    tree: dict[str, Tree] = {}
    for key_node, value_node in node.value:
        key = Key(key_node.value)
        key.text, key.mark = text, key_node.start_mark
        tree[key] = tree_of(value_node, text, check)
    return tree


class YamlReader(MessageReader):
    """Reader of messages from trees of words. A string is the text itself.

    YAML would read `12:30` as the number 750, and `no` as False. The number of a field may also be
    in quotes. A list without a value is empty.
    """

    def items(self, slot: Slot, value: Tree) -> Any:
        """Return the elements of a list. A value that is no list is returned as plain values."""
        if isinstance(value, list):
            numbers = [item.value if isinstance(item, Word) else None for item in value]
            return numbers if slot.has_plain(numbers) else value
        if isinstance(value, dict):
            return plain_tree(value)
        if value.value is None:
            return []
        return octets(value.text) if slot.is_octets else value.text

    def leaf(self, slot: Slot, value: Tree) -> Any:
        """Return a number, a string or a bool. A value that does not fit is returned as it is."""
        if not isinstance(value, Word):
            return plain_tree(value)
        if slot.is_float and value.value.__class__ is float and math.isfinite(value.value):
            return value.value
        if slot.type.is_string:
            return "" if value.value is None else value.text
        if slot.type.base == "bool":
            is_one = isinstance(value.value, (bool, int)) and value.value in {0, 1}
            return bool(value.value) if is_one else value.text
        if value.value is None:
            return math.nan if value.text and slot.is_float else value.text or None
        number = None if isinstance(value.value, bool) else _number(value, is_float=slot.is_float)
        return value.text if number is None else number

    def no_dictionary(self, message: Any, value: Tree, path: str) -> Exception:
        """Return the error for a message that is not a dictionary."""
        return super().no_dictionary(message, getattr(value, "value", value), path)


def plain_tree(tree: Tree) -> Any:
    """Return the dictionaries, lists and texts of a tree."""
    if isinstance(tree, dict):
        return {name: plain_tree(branch) for name, branch in tree.items()}
    return [plain_tree(branch) for branch in tree] if isinstance(tree, list) else tree.text


def _number(word: Word, *, is_float: bool) -> int | float | None:
    """Return the number of a word, or None if it is not a number of this type."""
    value = word.value
    try:
        if isinstance(value, int):
            return value
        if not is_float and isinstance(value, str):
            value = _integer_or_float(value)
        number = float(value)
    except (TypeError, ValueError, OverflowError):
        return None
    if not is_float:
        return int(value) if number.is_integer() else None
    is_too_large = math.isinf(number) and "inf" not in word.text.lower()
    return None if is_too_large else number


def _integer_or_float(text: str) -> int | float:
    try:
        return int(text, 0)
    except ValueError:
        return float(text)
