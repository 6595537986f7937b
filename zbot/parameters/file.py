"""Reader of parameter files, which are YAML with parameter values for each node.

/robot_1/lidar:          # a node: `*` matches one part of a name, `**` any number of parts
  ros__parameters:
    rate_hz: 10.0
    filter:
      size: 3            # the parameter `filter.size`
"""

from __future__ import annotations

import re
from codecs import BOM_UTF16_BE, BOM_UTF16_LE
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from zbot.errors import InvalidNameError
from zbot.errors.suggestion import similar_names
from zbot.names import validate_node_name
from zbot.parameters.errors import (
    ParametersFileError,
    ParametersFileNotFoundError,
    ParameterValueError,
)
from zbot.parameters.scalar import LETTERS, scalar_value
from zbot.text.yaml_reader import YamlError, compose_untagged

if TYPE_CHECKING:
    from collections.abc import Iterator

__all__ = ["load", "matches", "parse_value", "sections"]

_KEY = "ros__parameters"
_MAX_NAME = 500  #: characters of a node or a parameter. Each value below a long name repeats it
_STRING_TAG = "tag:yaml.org,2002:str"
#: Paths of the files that had parameters for a node of this process.
_used_files: set[str] = set()


def parse_value(text: str, *, of_one_kind: bool = False) -> Any:
    """Return the value of a parameter written as YAML, e.g. `1.5`, `true`, `[1, 2]` or `hello`.

    Args:
        text: The YAML.
        of_one_kind: Whether to reject a list with values of several types.

    Raises:
        ParameterValueError: The text is not YAML, or not a value that a parameter can have.
    """
    try:
        nodes = compose_untagged(text)
    except YamlError as error:
        raise ParameterValueError(text, str(error)) from error
    if len(nodes) > 1:
        raise ParameterValueError(text, "it has several values, separated by `---`")
    value = _value(nodes[0]) if nodes else None
    _check(text, value, of_one_kind=of_one_kind)
    return value


def load(path: str, node: str) -> dict[str, Any]:
    """Return the parameters that a file has for a node. Dots join the parts of nested names.

    Args:
        path: The YAML file.
        node: Fully qualified name of the node.

    Raises:
        ParametersFileError: The file cannot be read, or does not have ROS 2's format.
    """
    values: dict[str, Any] = {}
    for pattern, parameters in sections(path):
        if matches(pattern, node):
            values.update(parameters)
    return values


def sections(path: str) -> list[tuple[str, dict[str, Any]]]:
    """Return a file's node patterns with their parameters. Dots join the parts of nested names.

    A pattern begins with a slash. The same pattern may occur several times.

    Raises:
        ParametersFileError: The file cannot be read, or does not have ROS 2's format.
    """
    text = _text(path)
    try:
        documents = [document for document in compose_untagged(text) if not _is_empty(document)]
        return [found for document in documents for found in _sections(path, "", document)]
    except (YamlError, ParametersFileError) as error:
        from zbot.text.typographic import advice  # noqa: PLC0415 - only for mistakes

        reason = error.reason if isinstance(error, ParametersFileError) else str(error)
        raise ParametersFileError(path, "; ".join(filter(None, (reason, advice(text))))) from error


def unused(path: str, node: str) -> list[str]:
    """Return the nodes of a file that is probably meant for a node, but has another name for it.

    A file often has parameters for many nodes, and is given to others too. So the result is empty
    if the file has several nodes and no similar name, or if an earlier node of the process has
    used the file.
    """
    patterns = [pattern for pattern, _ in sections(path)]
    if any(matches(pattern, node) for pattern in patterns):
        _used_files.add(path)
    if path in _used_files:
        return []
    base_names = {pattern.rpartition("/")[2]: pattern for pattern in patterns}
    is_meant = len(patterns) == 1 or similar_names(node.rpartition("/")[2], base_names)
    return patterns if is_meant else []


def matches(pattern: str, node: str) -> bool:
    """Return whether a node's full name matches a pattern such as `/**`, `/ns/*` or `lidar`."""
    parts = pattern.strip("/").split("/")
    expression = "".join(
        {"**": "(?:/[^/]+)*", "*": "/[^/]+"}.get(p, f"/{re.escape(p)}") for p in parts
    )
    return re.fullmatch(expression, node) is not None


def _text(path: str) -> str:
    try:
        data = Path(path).read_bytes()
        # In Windows PowerShell, `zbot param dump /node > file` writes UTF-16.
        return data.decode("utf-16" if data.startswith((BOM_UTF16_LE, BOM_UTF16_BE)) else "utf-8")
    except FileNotFoundError as error:
        raise ParametersFileNotFoundError(path, error.strerror or str(error)) from error
    except OSError as error:
        raise ParametersFileError(path, error.strerror or str(error)) from error
    except UnicodeDecodeError as error:
        raise ParametersFileError(
            path, f"it is not UTF-8 text: save it as UTF-8 ({error})"
        ) from error


def _sections(path: str, name: str, node: Any) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield the node patterns below a name with their parameters."""
    if node.id != "mapping":
        raise ParametersFileError(path, _missing_key(name, _value(node)))
    for key, value in _pairs(node):
        if key == _KEY and name:
            _validate_pattern(path, name)
            yield _absolute(name), _Collector(path, _absolute(name), value).values
        elif key == _KEY:
            raise ParametersFileError(path, f"write {_KEY} below a node's name, e.g. `/**:`")
        else:
            separator = "" if not name or name.endswith("/") else "/"
            inner = f"{name}{separator}{key}"
            if len(inner) > _MAX_NAME:
                raise ParametersFileError(path, f"a name has more than {_MAX_NAME} characters")
            yield from _sections(path, inner, value)


def _missing_key(name: str, content: Any) -> str:
    """Return what to write, because a name has a value and is not below `ros__parameters`."""
    parts = name.strip("/").split("/")
    if not name:
        return f"at the top write `name:` and indented lines below it, not {content!r}"
    wrong = next((part for part in parts if similar_names(part, [_KEY, "parameters"])), "")
    if not wrong and "parameters" in parts:
        wrong = "parameters"
    if wrong:
        return f"write {_KEY} in place of {wrong}"
    node = parts[0] if len(parts) > 1 or content is None else "/**"
    return f"write the line `{_KEY}:` below `{node}:`, and indent the parameters below it"


def _absolute(name: str) -> str:
    return f"/{name.removeprefix('/')}"


def _validate_pattern(path: str, name: str) -> None:
    for part in _absolute(name)[1:].split("/"):
        problem = _problem_with(part)
        if problem is not None:
            reason = f"{name!r} is not a node's name: {problem}"
            raise ParametersFileError(path, reason) from problem


@lru_cache(maxsize=512)  # a file has the same names for many nodes
def _problem_with(part: str) -> InvalidNameError | None:
    try:
        if part not in {"*", "**"}:
            validate_node_name(part)
    except InvalidNameError as error:
        return error
    return None


class _Collector:
    """Reader of one node's parameters, in which dots join the parts of nested names.

    ROS 2 reads a map in a list as a group: `front: [{pins: [a, b]}]` is `front.pins`. It does not
    read all such lists. Lists of which it would lose a part are refused.

    Attributes:
        values: The values by name.
    """

    def __init__(self, path: str, node_name: str, node: Any) -> None:
        self.values: dict[str, Any] = {}
        self._path = path
        self._name = ""  #: of the parameter that was begun last
        self._is_in_list = False
        self._read(node)
        if "" in self.values:
            reason = f"{_KEY} of {node_name!r} needs lines `name: value` with a space after ':'"
            raise ParametersFileError(path, reason)
        for name, value in self.values.items():
            try:
                _check(name, value, of_one_kind=True)
            except ParameterValueError as error:
                raise ParametersFileError(path, str(error)) from error

    def _read(self, node: Any) -> None:
        if node.id == "mapping":
            self._read_mapping(node)
        elif node.id == "sequence":
            self._read_list(node)
        elif _is_empty(node) and self._name:
            raise self._error(node, f"{self._name!r} has no value: write one, or remove the name")
        elif self._is_in_list:
            self.values[self._name].append(_value(node))
        else:
            self.values[self._name] = _value(node)

    def _read_mapping(self, node: Any) -> None:
        group = self._name
        for index, (key, value) in enumerate(_pairs(node)):
            if not key:
                raise self._error(value, "a parameter's name is missing: write `name: value`")
            if self._is_in_list and index:
                raise self._error(
                    value, f"{self._name!r} is in a list, so {key!r} cannot follow it"
                )
            self._name = f"{group}.{key}" if group else key
            if len(self._name) > _MAX_NAME:
                raise self._error(value, f"a name has more than {_MAX_NAME} characters")
            if group in self.values:
                self.values[self._name] = self.values.pop(group)
            self._read(value)

    def _read_list(self, node: Any) -> None:
        if all(item.id == "scalar" for item in node.value):
            self.values[self._name] = _items(node.value)
            self._is_in_list = False
            return
        self._is_in_list = True
        self.values[self._name] = []
        for item in node.value:
            if item.id == "sequence":
                raise self._error(item, f"{self._name!r} is a list, so it cannot contain a list")
            if item.id == "scalar" and not self._is_in_list:
                raise self._error(item, f"a value cannot follow the list {self._name!r}")
            self._read(item)
        self._is_in_list = False

    def _error(self, node: Any, reason: str) -> ParametersFileError:
        return ParametersFileError(self._path, f"line {node.start_mark.line + 1}: {reason}")


def _pairs(node: Any) -> Iterator[tuple[str, Any]]:
    """Yield the names and values of a mapping, also those of YAML's merge key `<<`."""
    own: list[tuple[str, Any]] = []
    merged: list[Any] = []
    for key, value in node.value:
        name = key.value if key.id == "scalar" else ""
        mappings = value.value if value.id == "sequence" else [value]
        if name == "<<" and all(mapping.id == "mapping" for mapping in mappings):
            merged += mappings
        else:
            own.append((name, value))
    known = {name for name, _ in own}
    for mapping in merged:
        pairs = [pair for pair in _pairs(mapping) if pair[0] not in known]
        known.update(name for name, _ in pairs)
        yield from pairs
    yield from own


def _value(node: Any) -> Any:
    """Return the value of a node, or None if it is empty."""
    if node.id == "mapping":
        return {key: _value(value) for key, value in _pairs(node)}
    if node.id == "sequence":
        return _items(node.value)
    if node.style in {"'", '"'} or node.tag == _STRING_TAG:
        return node.value
    return None if _is_empty(node) else scalar_value(node.value)


def _items(nodes: list[Any]) -> list[Any]:
    """Return the values of a list's items. `y` and `n` are strings beside other strings."""
    values = [_value(node) for node in nodes]
    if not any(isinstance(value, str) for value in values):
        return values
    is_letter = [isinstance(node.value, str) and node.value in LETTERS for node in nodes]
    return [
        node.value if is_one else value
        for node, value, is_one in zip(nodes, values, is_letter, strict=True)
    ]


def _is_empty(node: Any) -> bool:
    return node.id == "scalar" and not node.value and not node.style


def _check(text: str, value: Any, *, of_one_kind: bool) -> None:
    items = value if isinstance(value, list) else [value]
    if any(not isinstance(item, (bool, int, float, str)) for item in items):
        reason = "a parameter is a bool, a number, a string or a list of one of these"
        raise ParameterValueError(text, reason)
    if of_one_kind and len({float if type(item) is int else type(item) for item in items}) > 1:
        raise ParameterValueError(text, f"the values of a list must have one type, not {value!r}")
