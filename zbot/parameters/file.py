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

from zbot.parameters.errors import (
    ParametersFileError,
    ParametersFileNotFoundError,
    ParameterValueError,
)
from zbot.suggestion import similar_names
from zbot.yaml_reader import YamlError, read_yaml

if TYPE_CHECKING:
    from collections.abc import Iterator

__all__ = ["load", "matches", "parse_value", "sections"]

_KEY = "ros__parameters"
#: Paths of the files that had parameters for a node of this process.
_used_files: set[str] = set()
# PyYAML matches these patterns at the start of a scalar. `\Z` lets them match only whole scalars.
_FLOAT = re.compile(
    r"[-+]?(?:[0-9][0-9_]*\.[0-9_]*|\.[0-9]+|[0-9]+(?=[eE]))(?:[eE][-+]?[0-9]+)?\Z"
    r"|[-+]?\.(?:inf|Inf|INF)\Z|\.(?:nan|NaN|NAN)\Z"
)
_INTEGER = re.compile(r"[-+]?(?:0x[0-9a-fA-F]+|0b[01]+|0o?[0-7]*|[1-9][0-9_]*)\Z")


def parse_value(text: str, *, of_one_kind: bool = False) -> Any:
    """Return the value of a parameter written as YAML, e.g. `1.5`, `true`, `[1, 2]` or `hello`.

    Args:
        text: The YAML.
        of_one_kind: Whether to reject a list with values of several types.

    Raises:
        ParameterValueError: The text is not YAML, or not a value that a parameter can have.
    """
    try:
        value = read_yaml(text, _loader())
    except YamlError as error:
        raise ParameterValueError(text, str(error)) from error
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

    Raises:
        ParametersFileError: The file cannot be read, or does not have ROS 2's format.
    """
    try:
        return [(pattern, _flat(path, "", parameters)) for pattern, parameters in _sections(path)]
    except RecursionError as error:
        raise ParametersFileError(path, "it is nested too deeply") from error


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


def _sections(path: str) -> Iterator[tuple[str, dict[Any, Any]]]:
    """Yield each node pattern of a file with its parameters. Nested parameters stay nested."""
    try:
        data = Path(path).read_bytes()
        # In Windows PowerShell, `zbot param dump /node > file` writes UTF-16.
        text = data.decode("utf-16" if data.startswith((BOM_UTF16_LE, BOM_UTF16_BE)) else "utf-8")
    except FileNotFoundError as error:
        raise ParametersFileNotFoundError(path, error.strerror or str(error)) from error
    except OSError as error:
        raise ParametersFileError(path, error.strerror or str(error)) from error
    except ValueError as error:
        raise ParametersFileError(path, str(error)) from error
    try:
        content = read_yaml(text, _loader())
        if content is not None:
            yield from _nested_sections(path, "", content)
    except (YamlError, ParametersFileError) as error:
        from zbot.terminal.typographic import advice  # noqa: PLC0415 - only for mistakes

        reason = error.reason if isinstance(error, ParametersFileError) else str(error)
        raise ParametersFileError(path, "; ".join(filter(None, (reason, advice(text))))) from error


def _nested_sections(path: str, name: str, content: Any) -> Iterator[tuple[str, dict[Any, Any]]]:
    if not isinstance(content, dict):
        raise ParametersFileError(path, _missing_key(name, content))
    for key, value in content.items():
        if key == _KEY and name:
            if not isinstance(value, dict):
                reason = f"{_KEY} of {name!r} needs lines `name: value` with a space after ':'"
                raise ParametersFileError(path, reason)
            yield name, value
        elif key == _KEY:
            raise ParametersFileError(path, f"write {_KEY} below a node's name, e.g. `/**:`")
        else:
            yield from _nested_sections(path, f"{name}/{str(key).strip('/')}", value)


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


def _flat(path: str, prefix: str, values: dict[Any, Any]) -> dict[str, Any]:
    flat: dict[str, Any] = {}
    for key, value in values.items():
        name = f"{prefix}{key}"
        if isinstance(value, dict):
            flat.update(_flat(path, f"{name}.", value))
            continue
        try:
            _check(name, value, of_one_kind=True)
        except ParameterValueError as error:
            raise ParametersFileError(path, str(error)) from error
        flat[name] = value
    return flat


def _check(text: str, value: Any, *, of_one_kind: bool) -> None:
    items = value if isinstance(value, list) else [value]
    if any(not isinstance(item, (bool, int, float, str)) for item in items):
        reason = "a parameter is a bool, a number, a string or a list of one of these"
        raise ParameterValueError(text, reason)
    if of_one_kind and len({float if type(item) is int else type(item) for item in items}) > 1:
        raise ParameterValueError(text, f"the values of a list must have one type, not {value!r}")
    if any(isinstance(item, int) and not -(2**63) <= item < 2**63 for item in items):
        raise ParameterValueError(text, "an integer must fit in 64 bits")


def _yaml() -> Any:
    # PyYAML is imported here: the import takes 15 ms, and most command lines have no parameters.
    import yaml  # noqa: PLC0415

    return yaml


@lru_cache(maxsize=1)
def _loader() -> Any:
    """Return YAML's safe loader with ROS 2's rules for scalars.

    Dates, `null` and `~` are strings. `1e3` is a number. Only an empty value is None. If a key
    occurs twice and both values are mappings, the loader merges them. PyYAML's own loader keeps
    only the second mapping.
    """
    base = _yaml().SafeLoader

    def construct_mapping(self: Any, node: Any, deep: bool = False) -> Any:
        joined = _yaml().MappingNode(node.tag, _joined(node.value), node.start_mark, node.end_mark)
        return base.construct_mapping(self, joined, deep)

    members = {"yaml_implicit_resolvers": {}, "construct_mapping": construct_mapping}
    loader: Any = type("_Loader", (base,), members)
    for first, resolvers in base.yaml_implicit_resolvers.items():
        kept = {"bool", "merge"} if first else {"null"}
        loader.yaml_implicit_resolvers[first] = [
            r for r in resolvers if r[0].split(":")[-1] in kept
        ]
    loader.add_implicit_resolver("tag:yaml.org,2002:float", _FLOAT, list("-+.0123456789"))
    loader.add_implicit_resolver("tag:yaml.org,2002:int", _INTEGER, list("-+0123456789"))
    return loader


def _joined(pairs: list[tuple[Any, Any]]) -> list[tuple[Any, Any]]:
    """Return a mapping's pairs. The mappings of a repeated key are merged into one mapping."""
    yaml = _yaml()
    found: dict[Any, tuple[Any, Any]] = {}
    for key, value in pairs:
        # Pairs whose key is YAML's merge key `<<`, or is not a scalar, stay as they are.
        is_word = isinstance(key, yaml.ScalarNode) and not key.tag.endswith(":merge")
        identity = (key.tag, key.value) if is_word else id(key)
        _, before = found.get(identity, (None, None))
        if isinstance(before, yaml.MappingNode) and isinstance(value, yaml.MappingNode):
            lines = [*before.value, *value.value]
            value = yaml.MappingNode(value.tag, lines, before.start_mark, value.end_mark)  # noqa: PLW2901
        found[identity] = (key, value)
    return list(found.values())
