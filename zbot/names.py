"""Rules of ROS 2 for node, namespace, topic, service and parameter names.

The rules and their order are those of ROS 2's own validators. Only ASCII letters and ASCII digits
count as letters and digits. An error shows the wrong character and its position.
"""

from __future__ import annotations

import re
from typing import Literal

from zbot.errors import (
    ArgumentTypeError,
    InvalidNamespaceError,
    InvalidNodeNameError,
    InvalidParameterError,
    InvalidServiceNameError,
    InvalidTopicNameError,
)

__all__ = [
    "KINDS",
    "ROSOUT_TOPIC",
    "SEND_GOAL",
    "expand_topic_name",
    "fully_qualified",
    "is_hidden",
    "split_fully_qualified",
    "validate_full_topic_name",
    "validate_namespace",
    "validate_node_name",
    "validate_parameter_name",
    "validate_topic_name",
]

#: kinds of interfaces: folders in a package, extensions of files, middle parts of full names
KINDS = ("msg", "srv", "action")
#: topic on which nodes publish their log lines
ROSOUT_TOPIC = "/rosout"
#: the names of an action's topics and services are the action's name, this part, and a last part
ACTION_PART = "/_action/"
SEND_GOAL = f"{ACTION_PART}send_goal"  #: the end of the name of an action's send-goal service

MAX_TOPIC_NAME_LENGTH = 247  # as in ROS 2: 255 minus 8 for a middleware's own prefix
MAX_NODE_NAME_LENGTH = 255
MAX_NAMESPACE_LENGTH = 245  # as in ROS 2: a topic name's limit minus "/" and one character

_WORD = re.compile(r"[A-Za-z0-9_]*")
_ABSOLUTE = re.compile(r"[A-Za-z0-9_/]*")
# An optional "~", then plain characters and {substitutions} that do not start with a digit.
_RELATIVE = re.compile(r"~?(?:[A-Za-z0-9_/]|\{(?![0-9])[A-Za-z0-9_]*\})*")
_DIGIT_TOKEN = re.compile(r"(?:^|/)[0-9]")
_SUBSTITUTION = re.compile(r"\{([A-Za-z0-9_]*)\}")

#: the rule that a name breaks, and the index of the first wrong character
Fault = tuple[str, int]


def validate_node_name(node_name: str) -> Literal[True]:
    """Check a node's base name, without a namespace.

    Raises:
        InvalidNodeNameError: The name is empty, too long, starts with a digit or has a character
            other than letters, digits and `_`.
        ArgumentTypeError: The name is not a string.
    """
    fault = _node_name_fault(_require_string("node name", node_name))
    if fault is not None:
        raise InvalidNodeNameError(node_name, *fault)
    return True


def validate_namespace(namespace: str) -> Literal[True]:
    """Check an absolute namespace: `/`, `/robot_1`, `/fleet/robot_1`.

    Raises:
        InvalidNamespaceError: The namespace is not absolute, ends with `/`, repeats `/`, is too
            long or has a forbidden character.
        ArgumentTypeError: The namespace is not a string.
    """
    if _require_string("namespace", namespace) == "/":
        return True
    fault = _absolute_fault("namespace", namespace, MAX_NAMESPACE_LENGTH)
    if fault is not None:
        raise InvalidNamespaceError(namespace, *fault)
    return True


def validate_topic_name(name: str, *, is_service: bool = False) -> Literal[True]:
    """Check a topic or service name as a program writes it, before its expansion.

    The name is relative (`scan`), private (`~/scan`) or absolute (`/scan`). It may have
    `{substitutions}`. As in ROS 2, this check accepts a repeated `/`. The check after the expansion
    rejects it.

    Raises:
        InvalidTopicNameError: The name breaks the grammar.
        InvalidServiceNameError: The same as above, if `is_service` is true.
        ArgumentTypeError: The name is not a string.
    """
    kind = "service name" if is_service else "topic name"
    fault = _relative_fault(kind, _require_string(kind, name))
    if fault is not None:
        raise (InvalidServiceNameError if is_service else InvalidTopicNameError)(name, *fault)
    return True


def validate_full_topic_name(name: str, *, is_service: bool = False) -> Literal[True]:
    """Check a fully qualified topic or service name, after its expansion.

    Raises:
        InvalidTopicNameError: The name breaks the grammar or has more than 247 characters.
        InvalidServiceNameError: The same as above, if `is_service` is true.
        ArgumentTypeError: The name is not a string.
    """
    kind = "service name" if is_service else "topic name"
    fault = _absolute_fault(kind, _require_string(kind, name), MAX_TOPIC_NAME_LENGTH)
    if fault is not None:
        raise (InvalidServiceNameError if is_service else InvalidTopicNameError)(name, *fault)
    return True


def validate_parameter_name(name: str) -> Literal[True]:
    """Check that a parameter name is not empty, which is ROS 2's only rule.

    Raises:
        InvalidParameterError: The name is empty.
        ArgumentTypeError: The name is not a string.
    """
    if not _require_string("parameter name", name):
        raise InvalidParameterError(name)
    return True


def expand_topic_name(topic_name: str, node_name: str, node_namespace: str) -> str:
    """Return the absolute form of a name, with its namespace, and without `~`, `{node}` and `{ns}`.

    The result may still break the rules for full names (`/{ns}/a` gives `//ns/a`), as in ROS 2.
    Pass the result to `validate_full_topic_name` after remapping.

    Raises:
        InvalidTopicNameError: The name breaks the grammar or has an unknown `{substitution}`.
        InvalidNodeNameError: The node's name is invalid.
        InvalidNamespaceError: The node's namespace is invalid.
    """
    validate_topic_name(topic_name)
    validate_node_name(node_name)
    validate_namespace(node_namespace)
    name = topic_name
    if name.startswith("~"):
        name = fully_qualified(node_namespace, node_name) + name[1:]
    if "{" in name:
        name = _substitute(topic_name, name, node_name, node_namespace)
    if not name.startswith("/"):
        name = fully_qualified(node_namespace, name)
    return name


def fully_qualified(namespace: str, node: str) -> str:
    """Join a namespace and a relative name: `/` and `a` give `/a`, `/ns` and `a` give `/ns/a`."""
    return f"{namespace.rstrip('/')}/{node}"


def split_fully_qualified(name: str) -> tuple[str, str]:
    """Return the namespace and the base name: `("/ns", "a")` for `/ns/a`, `("/", "a")` for `a`."""
    namespace, _, base = name.rpartition("/")
    return namespace or "/", base


def is_hidden(name: str) -> bool:
    """Return whether a part of the name starts with `_`. Tools do not list such names."""
    return name.startswith("_") or "/_" in name


def _require_string(what: str, value: str) -> str:
    if not isinstance(value, str):
        raise ArgumentTypeError(what, "a string", value)
    return value


def _node_name_fault(name: str) -> Fault | None:
    if not name:
        return "node name must not be empty", 0
    if len(name) > MAX_NODE_NAME_LENGTH:
        reason = f"node name must not be longer than {MAX_NODE_NAME_LENGTH} characters"
        return reason, MAX_NODE_NAME_LENGTH
    bad = _first_not_in(_WORD, name)
    if bad is not None:
        return "node name must not contain characters other than letters, digits and '_'", bad
    if name[0].isdigit():
        return "node name must not start with a number", 0
    return None


def _absolute_fault(kind: str, name: str, max_length: int) -> Fault | None:
    if not name:
        return f"{kind} must not be empty", 0
    if not name.startswith("/"):
        return f"{kind} must be absolute: it must start with '/'", 0
    if name.endswith("/"):
        return f"{kind} must not end with '/'", len(name) - 1
    bad = _first_not_in(_ABSOLUTE, name)
    if bad is not None:
        return f"{kind} must not contain characters other than letters, digits, '_' and '/'", bad
    if "//" in name:
        return f"{kind} must not repeat '/'", name.index("//") + 1
    digit = _DIGIT_TOKEN.search(name)
    if digit is not None:
        return f"{kind} token must not start with a number", digit.end() - 1
    if len(name) > max_length:
        return f"{kind} must not be longer than {max_length} characters", max_length
    return None


def _relative_fault(kind: str, name: str) -> Fault | None:
    if not name:
        return f"{kind} must not be empty", 0
    if name.endswith("/"):
        return f"{kind} must not end with '/'", len(name) - 1
    fault = _character_fault(kind, name)
    if fault is not None:
        return fault
    if name.startswith("~") and len(name) > 1 and name[1] != "/":
        return f"{kind} must have '/' after '~'", 1
    digit = _DIGIT_TOKEN.search(name)
    if digit is not None:
        return f"{kind} token must not start with a number", digit.end() - 1
    return None


def _character_fault(kind: str, name: str) -> Fault | None:
    index = _first_not_in(_RELATIVE, name)
    if index is None:
        return None
    match name[index]:
        case "~":
            return f"{kind} must not have '~' except as its first character", index
        case "}":
            return f"{kind} must not have '}}' without a '{{' before it", index
        case "{":
            return _substitution_fault(kind, name, index)
    allowed = "letters, digits, '_', '/', '~', '{' and '}'"
    return f"{kind} must not contain characters other than {allowed}", index


def _substitution_fault(kind: str, name: str, opened: int) -> Fault:
    if name[opened + 1 : opened + 2].isdigit():
        return f"{kind} must not have a digit after '{{'", opened + 1
    bad = _first_not_in(_WORD, name[opened + 1 :])
    if bad is None:
        return f"{kind} must not have '{{' without a '}}' after it", opened
    reason = f"{kind} must have only letters, digits and '_' between '{{' and '}}'"
    return reason, opened + 1 + bad


def _first_not_in(allowed: re.Pattern[str], name: str) -> int | None:
    match = allowed.match(name)
    end = match.end() if match else 0
    return end if end < len(name) else None


def _substitute(original: str, name: str, node: str, namespace: str) -> str:
    values = {"node": node, "ns": namespace, "namespace": namespace}

    def value(match: re.Match[str]) -> str:
        word = match.group(1)
        if word not in values:
            reason = f"topic name must not have the unknown substitution '{{{word}}}'"
            raise InvalidTopicNameError(original, reason, original.index(match.group()))
        return values[word]

    return _SUBSTITUTION.sub(value, name)
