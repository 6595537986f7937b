"""Reader of YAML, with limits. It raises only `YamlError`. All of zbot reads YAML with this module.

A text of some kilobytes can crash libyaml (thousands of brackets), or describe more values than the
memory holds (aliases of aliases). So the events of a text are checked before any value is made.
"""

from __future__ import annotations

import re
from contextlib import suppress
from functools import cache
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError

if TYPE_CHECKING:
    from collections.abc import Sequence

_MAX_CHARACTERS = 10_000_000
_MAX_LEVELS = 100
_MAX_NODES = 1_000_000  #: number of values after each alias is replaced by its value
_MAX_ALIASED = 100_000  #: number of values that aliases stand for
_MAX_SLOW = 30_000  #: characters of a text for PyYAML's own parser, which needs 0.6 s for them
_NUMBER_TAGS = frozenset({"tag:yaml.org,2002:int", "tag:yaml.org,2002:float"})
_LONGEST_NUMBER = 400
# `int` takes very long for such texts, or Python does not write their numbers. `:` occurs in
# numbers to the base 60, such as `1:30`.
_LONG_NUMBER = re.compile(r"[-+]?(?:[0-9][0-9_:.]{400,}|0x[0-9a-fA-F_]{400,}|0b[01_]{400,})\Z")
_COLON = "; a line before it needs a colon at its end, or a text with a colon needs quotes"
_ADVICE = {
    "mapping values are not allowed here": _COLON,
    "mapping values are not allowed in this context": _COLON,  # libyaml's text
    "expected alphabetic or numeric character, but found '*'": (
        "; a text that begins with * needs quotes, and all nodes are /**"
    ),
}
_TAB_PROBLEM = "found character '\\t' that cannot start any token"
#: Exceptions of PyYAML for scalars such as `2024-13-01`, `!!bool x`, `!!int ""`.
_SCALAR_ERRORS = (ArithmeticError, AttributeError, LookupError, TypeError, ValueError)


class YamlError(ZbotError, ValueError):
    """A text is not YAML that zbot accepts.

    Attributes:
        problem: What is wrong.
        line: Line number from 0, or None if the error is about the whole text.
        column: Column from 0.
    """

    def __init__(self, problem: str, line: int | None = None, column: int = 0) -> None:
        self.problem, self.line, self.column = problem, line, column
        where = "" if line is None else f"line {line + 1}, column {column + 1}: "
        super().__init__(f"{where}{problem}")


def read_yaml(text: str, *, as_strings: bool = False) -> Any:
    """Return the value of the only document in a text. Return None if the text is empty.

    Args:
        text: The YAML.
        as_strings: Whether every scalar is a string, as it is written.

    Raises:
        YamlError: The text is not YAML, contains several documents, is nested deeper than 100
            levels or is too large, or a value does not fit its tag.
    """
    return construct_yaml(compose_yaml(text), as_strings=as_strings)


def compose_yaml(text: str) -> Any:
    """Return PyYAML's node of the only document in a text. Return None if the text is empty.

    Raises:
        YamlError: As for `read_yaml`.
    """
    found = _compose(text, _loaders())
    if len(found) > 1:
        mark = found[1].start_mark
        raise YamlError("but found another document", mark.line, mark.column)
    return found[0] if found else None


def compose_untagged(text: str) -> list[Any]:
    """Return PyYAML's nodes of all documents in a text.

    The tag of a scalar or collection is empty if the text does not contain a tag. So the caller
    decides by rules of its own whether `1e3`, `yes` or `null` is a number, a bool or a string.

    Raises:
        YamlError: As for `read_yaml`, but a text may contain several documents.
    """
    return _compose(text, [_untagged(loader) for loader in _loaders()])


def construct_yaml(node: Any, *, as_strings: bool = False) -> Any:
    """Return the value of a node of `compose_yaml`. The value of None is None.

    Args:
        node: The node.
        as_strings: Whether every scalar is a string, as it is written.

    Raises:
        YamlError: The tag is unknown, or the value does not fit its tag.
    """
    from yaml import YAMLError  # noqa: PLC0415 - takes 15 ms, and most commands read no YAML
    from yaml.constructor import BaseConstructor, SafeConstructor  # noqa: PLC0415 - as above

    if node is None:
        return None
    constructor = BaseConstructor() if as_strings else SafeConstructor()
    try:
        return constructor.construct_document(node)
    except YAMLError as error:
        raise _yaml_error(error) from error
    except RecursionError:
        raise YamlError(f"it is nested deeper than {_MAX_LEVELS} levels") from None
    except _SCALAR_ERRORS as error:
        raise YamlError(f"a value does not fit its type: {error}") from error


def _compose(text: str, loaders: Sequence[Any]) -> list[Any]:
    """Return the nodes of a text. The first of PyYAML's loaders that accepts the text is used."""
    import yaml  # noqa: PLC0415 - as above

    *others, last = loaders[:1] if len(text) > _MAX_SLOW else loaders
    for loader in others:
        with suppress(yaml.YAMLError):
            return _documents(text, loader)
    try:
        return _documents(text, last)
    except yaml.YAMLError as error:
        raise _yaml_error(error) from error


def _documents(text: str, loader: Any) -> list[Any]:
    import yaml  # noqa: PLC0415 - as above

    _check(text, loader)
    return list(yaml.compose_all(text, Loader=loader))


def _loaders() -> list[Any]:
    """Return PyYAML's loaders. Each accepts texts that the other does not accept.

    libyaml is ten times faster, and accepts tabs between words. PyYAML's own parser accepts
    `{header:{frame_id: x}}`, and its errors are clearer. A PyYAML that was built without libyaml
    has only the second one. The second one is not used for long texts, because it is slow.
    """
    import yaml  # noqa: PLC0415 - as above

    fast = getattr(yaml, "CSafeLoader", None)
    return [yaml.SafeLoader] if fast is None else [fast, yaml.SafeLoader]


@cache
def _untagged(loader: Any) -> Any:
    """Return a loader that does not guess the tag of a node."""
    return type("_Untagged", (loader,), {"resolve": lambda *_: ""})


def _check(text: str, loader: Any) -> None:
    """Check the limits of a text, before values are made. PyYAML's own errors pass through."""
    import yaml  # noqa: PLC0415 - as above

    if len(text) > _MAX_CHARACTERS:
        raise YamlError(f"it has more than {_MAX_CHARACTERS} characters")
    sizes = _Sizes()
    try:
        for event in yaml.parse(text, Loader=loader):
            sizes.add(event)
    except UnicodeEncodeError:
        raise YamlError("it has characters that UTF-8 cannot hold") from None


class _Sizes:
    """Numbers of values and of levels in the open collections of a text."""

    def __init__(self) -> None:
        self._open: list[tuple[str | None, int, int]] = [(None, 0, 0)]
        self._anchors: dict[str, tuple[int, int]] = {}
        self._aliased = 0

    def add(self, event: Any) -> None:
        kind = type(event).__name__
        if kind == "AliasEvent":
            if event.anchor not in self._anchors:
                raise _error_at(event, f"the alias *{event.anchor} is inside its own value")
            self._add_alias(event, *self._anchors[event.anchor])
        elif kind == "ScalarEvent":
            is_long = event.tag in _NUMBER_TAGS and len(event.value) > _LONGEST_NUMBER
            if is_long or _LONG_NUMBER.match(event.value):
                raise _error_at(event, f"a number has more than {_LONGEST_NUMBER} characters")
            self._close(event, event.anchor, 1, 0)
        elif kind in {"SequenceStartEvent", "MappingStartEvent"}:
            if len(self._open) > _MAX_LEVELS:
                raise _error_at(event, f"it is nested deeper than {_MAX_LEVELS} levels")
            self._anchors.pop(event.anchor, None)
            self._open.append((event.anchor, 1, 0))
        elif kind in {"SequenceEndEvent", "MappingEndEvent"}:
            anchor, size, levels = self._open.pop()
            self._close(event, anchor, size, levels + 1)

    def _add_alias(self, event: Any, size: int, levels: int) -> None:
        self._aliased += size
        if self._aliased > _MAX_ALIASED:
            raise _error_at(event, f"its aliases stand for more than {_MAX_ALIASED} values")
        if len(self._open) - 1 + levels > _MAX_LEVELS:  # an alias in an alias in an alias ...
            raise _error_at(event, f"it is nested deeper than {_MAX_LEVELS} levels")
        self._count(event, size, levels)

    def _close(self, event: Any, anchor: str | None, size: int, levels: int) -> None:
        if anchor is not None:
            self._anchors[anchor] = size, levels
        self._count(event, size, levels)

    def _count(self, event: Any, size: int, levels: int) -> None:
        anchor, before, deepest = self._open[-1]
        if before + size > _MAX_NODES:
            raise _error_at(event, f"it has more than {_MAX_NODES} values")
        self._open[-1] = anchor, before + size, max(deepest, levels)


def _error_at(event: Any, problem: str) -> YamlError:
    mark = event.start_mark
    return YamlError(problem, mark.line, mark.column)


def _yaml_error(error: Any) -> YamlError:
    mark, problem = getattr(error, "problem_mark", None), getattr(error, "problem", None)
    if mark is None or problem is None:
        return YamlError(problem or " ".join(str(error).split()))
    if problem == _TAB_PROBLEM:
        problem = "found a tab: write spaces in its place"
    return YamlError(f"{problem}{_ADVICE.get(problem, '')}", mark.line, mark.column)
