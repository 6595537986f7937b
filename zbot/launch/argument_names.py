"""Names of arguments that differ between launch files in Python, in XML and YAML, and of ROS 1."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.errors.suggestion import did_you_mean, question

if TYPE_CHECKING:
    from collections.abc import Iterable

#: Words for the same thing. Each form of launch files knows some of them.
_SAME = (
    ("package", "pkg", "package_name"),
    ("executable", "exec", "type", "node_executable", "exe"),
    ("name", "node_name", "node-name"),
    ("namespace", "ns", "node_namespace", "node-namespace"),
    ("parameters", "param", "params", "parameter", "rosparam"),
    ("remappings", "remap", "remapping", "remaps"),
    ("arguments", "args", "arg", "argument"),
    ("prefix", "launch-prefix", "launch_prefix"),
    ("default", "value", "default_value"),
)


def question_about(name: str, known: Iterable[str]) -> str:
    """Return `did you mean 'package'?` for `pkg`, or an empty string if there is no such name."""
    names = sorted(known)
    others = other_words(name)
    return question([known for known in names if known in others][:1]) or did_you_mean(name, names)


def other_words(name: str) -> tuple[str, ...]:
    """Return the words that other forms of launch files have for an argument."""
    found = next((words for words in _SAME if name in words), ())
    return tuple(word for word in found if word != name)
