"""Parser of a command line's ROS arguments. They are the words between `--ros-args` and `--`."""

from __future__ import annotations

import re
import sys
from collections import deque
from typing import TYPE_CHECKING, Any, NamedTuple

from zbot.errors import InvalidNameError
from zbot.log import configure, get_logging_severity_from_string
from zbot.names import (
    expand_topic_name,
    split_fully_qualified,
    validate_namespace,
    validate_node_name,
    validate_topic_name,
)
from zbot.parameters import file as parameter_file
from zbot.parameters.errors import ArgumentsError, ParameterValueError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

__all__ = [
    "Arguments",
    "LogLevel",
    "ParameterValue",
    "ParametersFile",
    "Remap",
    "configure_logging",
    "remove_ros_args",
]

_BEGIN, _END = "--ros-args", "--"
_ASSIGN = ":="
_LEVELS = ("unset", "debug", "info", "warn", "error", "fatal")
_NODE = re.compile(r"(?:(?P<node>[A-Za-z0-9_]+):(?!/))?(?P<rest>.*)", re.DOTALL)
_NO_PARAMETER_NAME = re.compile(r"^/|[*\s]")
_SCHEME = re.compile(r"(?:ros(?P<kind>topic|service)://)?(?P<name>.*)", re.DOTALL)


class Remap(NamedTuple):
    """One `-r [node:][scheme://]from:=to`."""

    source: str  #: topic or service name as written, `__node` or `__ns`
    target: str
    node: str = ""  #: base name of the node that the rule applies to. Empty means every node.
    kind: str = ""  #: `topic` or `service` if the rule applies to only one kind


class ParameterValue(NamedTuple):
    """One `-p [node:]name:=value`."""

    name: str
    value: Any  #: value read from the YAML text
    node: str = ""  #: base name of the node that the value applies to. Empty means every node.


class ParametersFile(NamedTuple):
    """One `--params-file path`. The file is read when a node asks for its parameters."""

    path: str


class LogLevel(NamedTuple):
    """One `--log-level [logger:=]level`."""

    level: str  #: in lower case: `unset`, `debug`, `info`, `warn`, `error` or `fatal`
    logger: str = ""  #: name of the logger. Empty means every logger.


class Arguments(NamedTuple):
    """Settings that a command line has for the nodes of its process."""

    remaps: tuple[Remap, ...] = ()
    parameters: tuple[ParameterValue | ParametersFile, ...] = ()  #: a name's last value is used
    log_levels: tuple[LogLevel, ...] = ()  #: a logger's last level is used
    log_file_name: str = ""
    rosout_logs: bool = True
    stdout_logs: bool = True
    external_lib_logs: bool = True
    enclave: str = "/"
    unparsed: tuple[str, ...] = ()  #: all other words, beginning with the program's name

    @classmethod
    def parse(cls, args: Sequence[str]) -> Arguments:
        """Return the settings in a command line.

        Raises:
            ArgumentsError: A word after `--ros-args` is unknown or not valid.
        """
        inside, unparsed = _split(args)
        words = deque(inside)
        for word in unparsed:
            if word.endswith("ros-args"):  # e.g. with the dash of a word processor
                _refuse_typographic(word)
        found, unknown = cls(unparsed=tuple(unparsed)), list[str]()
        while words:
            found = _flag(found, words, unknown)
        if unknown:
            _refuse_typographic(unknown[0])
            reason = "unknown flag: use -r, -p, --params-file or --log-level, and end with --"
            raise ArgumentsError(unknown, reason)
        return found

    def merged(self, after: Arguments) -> Arguments:
        """Return the settings of a node (`self`) together with those of the process (`after`).

        The node's settings have priority. The first remap that matches a name is used. The last
        value of a parameter is used.
        """
        return self._replace(
            remaps=self.remaps + after.remaps,
            parameters=after.parameters + self.parameters,
            log_levels=after.log_levels + self.log_levels,
            enclave=after.enclave if self.enclave == "/" else self.enclave,
        )

    def node_name_for(self, name: str) -> str:
        """Return the value of `__node:=` for the node `name`, or `name` if no value is given."""
        return self._special("__node", name) or name

    def namespace_for(self, node_name: str) -> str | None:
        """Return the value of `__ns:=` for the node `node_name`, or None if no value is given."""
        return self._special("__ns", node_name)

    def remapped(self, full_name: str, node: str, namespace: str, *, is_service: bool) -> str:
        """Return the name of a topic or service after remapping.

        Args:
            full_name: The fully qualified name.
            node: Base name of the node that uses the topic or service.
            namespace: That node's namespace.
            is_service: Whether it is the name of a service.
        """
        kind = "service" if is_service else "topic"
        for rule in self._of_names(node):
            if rule.kind not in {"", kind}:
                continue
            if expand_topic_name(rule.source, node, namespace) == full_name:
                return expand_topic_name(rule.target, node, namespace)
        return full_name

    def parameters_for(self, node: str) -> dict[str, Any]:
        """Return the parameter overrides for a node. `node` is the node's fully qualified name.

        Raises:
            ParametersFileError: A file cannot be read, or does not have ROS 2's format.
        """
        base, values = split_fully_qualified(node)[1], dict[str, Any]()
        for item in self.parameters:
            if isinstance(item, ParametersFile):
                values |= parameter_file.load(item.path, node)
            elif item.node in {"", base}:
                values[item.name] = item.value
        return values

    def names_for(self, node_name: str) -> set[str]:
        """Return the names that `-p` gives for the node `node_name`. Files are not read."""
        values = [
            parameter for parameter in self.parameters if isinstance(parameter, ParameterValue)
        ]
        return {value.name for value in values if value.node in {"", node_name}}

    def warnings_for(self, node: str) -> list[str]:
        """Return a warning for each parameter file that probably misspells the node's name.

        Args:
            node: The node's fully qualified name.
        """
        files = {item.path for item in self.parameters if isinstance(item, ParametersFile)}
        unused = ((path, parameter_file.unused(path, node)) for path in sorted(files))
        return [
            f"the parameter file {path} has parameters for {' and '.join(nodes)}, but not for "
            f"{node}: write {node} or /** as the name in the file"
            for path, nodes in unused
            if nodes
        ]

    def remapped_names(self, node: str, namespace: str) -> list[str]:
        """Return the full names of topics and services that a node's remappings change."""
        return [expand_topic_name(rule.source, node, namespace) for rule in self._of_names(node)]

    def _of_names(self, node: str) -> Iterator[Remap]:
        """Yield the rules for a node's topics and services. Others are for the node's own name."""
        for rule in self.remaps:
            if rule.node in {"", node} and rule.source not in {"__node", "__ns"}:
                yield rule

    def _special(self, source: str, node: str) -> str | None:
        for rule in self.remaps:
            if rule.source == source and rule.node in {"", node}:
                return rule.target
        return None


def _refuse_typographic(word: str) -> None:
    from zbot.text.typographic import advice_for_words  # noqa: PLC0415 - only for mistakes

    advice = advice_for_words([word])
    if advice:
        raise ArgumentsError(word, advice)


def remove_ros_args(args: Sequence[str] | None = None) -> list[str]:
    """Return a command line without its `--ros-args ... --` parts. The default is `sys.argv`."""
    return _split(sys.argv if args is None else args)[1]


def _split(args: Sequence[str]) -> tuple[list[str], list[str]]:
    """Return the words inside and outside of the `--ros-args ... --` parts."""
    inside: list[str] = []
    outside: list[str] = []
    in_ros_args = False
    for word in args:
        if word == _BEGIN:
            in_ros_args = True
        elif in_ros_args and word == _END:
            in_ros_args = False
        else:
            (inside if in_ros_args else outside).append(word)
    return inside, outside


def _flag(found: Arguments, words: deque[str], unknown: list[str]) -> Arguments:
    """Remove the first flag and its value from the words. Return the settings with this flag."""
    flag = words.popleft()
    switch = _SWITCHES.get(flag)
    if switch is not None:
        return found._replace(**switch)
    if flag not in _FLAGS:
        unknown.append(flag)
        return found
    if not words:
        raise ArgumentsError(flag, "the flag needs a value after it")
    return _FLAGS[flag](found, words.popleft())


def _remap(found: Arguments, word: str) -> Arguments:
    node, left, target = _assignment(word, "-r", "chatter:=/news")
    match = _SCHEME.fullmatch(left)
    kind, source = (match["kind"] or "", match["name"]) if match else ("", left)
    source = "__node" if source == "__name" else source
    try:
        _validate_remap(source, target)
    except InvalidNameError as error:
        raise ArgumentsError(word, str(error)) from None
    return found._replace(remaps=(*found.remaps, Remap(source, target, node, kind)))


def _validate_remap(source: str, target: str) -> None:
    if source == "__node":
        validate_node_name(target)
    elif source == "__ns":
        validate_namespace(target)
    else:
        validate_topic_name(source)
        validate_topic_name(target)


def _parameter(found: Arguments, word: str) -> Arguments:
    node, name, text = _assignment(word, "-p", "speed:=1.5")
    if _NO_PARAMETER_NAME.search(name):
        reason = f"{name!r} is not a parameter's name: write it as in `-p speed:=1.5`"
        raise ArgumentsError(word, reason)
    try:
        value = parameter_file.parse_value(text, of_one_kind=True)
    except ParameterValueError as error:
        raise ArgumentsError(word, str(error)) from None
    return found._replace(parameters=(*found.parameters, ParameterValue(name, value, node)))


def _log_level(found: Arguments, word: str) -> Arguments:
    logger, _, level = word.rpartition(_ASSIGN)
    if level.lower() not in _LEVELS or (not logger and _ASSIGN in word):
        raise ArgumentsError(word, f"use one of the levels {', '.join(_LEVELS)}")
    return found._replace(log_levels=(*found.log_levels, LogLevel(level.lower(), logger)))


def _assignment(word: str, flag: str, example: str) -> tuple[str, str, str]:
    """Return the node, the left side and the right side of `[node:]left:=right`."""
    left, assign, right = word.partition(_ASSIGN)
    if not assign:
        raise ArgumentsError(word, f"{_ASSIGN!r} is missing: write it as in `{flag} {example}`")
    match = _NODE.fullmatch(left)
    node, name = (match["node"] or "", match["rest"]) if match else ("", left)
    if not name or not right:
        missing = "name before" if not name else "value after"
        raise ArgumentsError(word, f"no {missing} {_ASSIGN!r}: write it as in `{flag} {example}`")
    return node, name, right


_FLAGS: dict[str, Callable[[Arguments, str], Arguments]] = {
    "-r": _remap,
    "--remap": _remap,
    "-p": _parameter,
    "--param": _parameter,
    "--params-file": lambda found, path: found._replace(
        parameters=(*found.parameters, ParametersFile(path))
    ),
    "--log-level": _log_level,
    "--log-config-file": lambda found, _: found,
    "--log-file-name": lambda found, prefix: found._replace(log_file_name=prefix),
    "-e": lambda found, path: found._replace(enclave=path),
    "--enclave": lambda found, path: found._replace(enclave=path),
}
_SWITCHES: dict[str, dict[str, Any]] = {
    f"--{verb}-{name.replace('_', '-')}": {name: verb == "enable"}
    for verb in ("enable", "disable")
    for name in ("rosout_logs", "stdout_logs", "external_lib_logs")
}


def configure_logging(arguments: Arguments) -> None:
    """Apply the log options of a command line."""
    levels = {
        level.logger: get_logging_severity_from_string(level.level)
        for level in arguments.log_levels
    }
    configure(
        levels=levels,
        stdout_enabled=arguments.stdout_logs,
        rosout_enabled=arguments.rosout_logs,
        file_enabled=arguments.external_lib_logs,
        file_prefix=arguments.log_file_name,
    )
