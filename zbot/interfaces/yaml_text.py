"""The one place that knows PyYAML: values to text as ros2 writes it, and text to nodes."""

from __future__ import annotations

from typing import Any

import yaml
from yaml import CollectionNode, MappingNode, Node, ScalarNode, SequenceNode, YAMLError
from yaml.constructor import SafeConstructor

__all__ = [
    "CollectionNode",
    "Flow",
    "MappingNode",
    "Node",
    "Quoted",
    "ScalarNode",
    "SequenceNode",
    "YAMLError",
    "compose",
    "dump",
    "scalar",
]

# libyaml writes and reads ten times faster; a PyYAML built without it lacks these names.
_BaseDumper: Any = getattr(yaml, "CSafeDumper", yaml.SafeDumper)
_Loader: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
_UNLIMITED = 2**31 - 1
# What PyYAML's own emitter makes of these line breaks does not read back.
_UNUSUAL_BREAKS = frozenset("\x85\u2028\u2029")


class Flow(list[Any]):
    """A list that is written on one line."""


class Quoted(str):
    """A text in quotes, which no reader can take for something else."""

    __slots__ = ()


def _represent_quoted(dumper: Any, data: Quoted) -> Any:
    return dumper.represent_scalar("tag:yaml.org,2002:str", str(data), style="'")


def _represent_flow(dumper: Any, data: Flow) -> Any:
    return dumper.represent_sequence("tag:yaml.org,2002:seq", data, flow_style=True)


class _Dumper(_BaseDumper):  # type: ignore[misc]
    """Writes every value in full, also one that occurs twice."""

    def ignore_aliases(self, data: object) -> bool:  # noqa: ARG002 - PyYAML's signature
        return True


class _WideDumper(yaml.SafeDumper):
    """Slower, and keeps what libyaml would escape: emoji and all else beyond the basic plane."""

    def ignore_aliases(self, data: object) -> bool:  # noqa: ARG002 - PyYAML's signature
        return True


_Dumper.add_representer(Flow, _represent_flow)
_WideDumper.add_representer(Flow, _represent_flow)
_Dumper.add_representer(Quoted, _represent_quoted)
_WideDumper.add_representer(Quoted, _represent_quoted)


def dump(value: Any, *, flow_style: bool = False) -> str:
    """Return a dictionary or list of plain types as YAML, ending with a newline.

    A block, unless `flow_style` puts everything on one line.
    """
    text = _dump(value, _Dumper, flow_style)
    if "\\U" in text:
        wide = _dump(value, _WideDumper, flow_style)
        return wide if _UNUSUAL_BREAKS.isdisjoint(wide) else text
    return text


def _dump(value: Any, dumper: Any, flow_style: bool) -> str:
    text: str = yaml.dump(
        value,
        Dumper=dumper,
        allow_unicode=True,
        default_flow_style=flow_style,
        sort_keys=False,
        width=_UNLIMITED,
    )
    return text


def compose(text: str) -> Node | None:
    """Return the node of a text's only document; None if it is empty.

    Raises:
        YAMLError: The text is no YAML.
    """
    node: Node | None = yaml.compose(text, Loader=_Loader)
    return node


def scalar(node: ScalarNode) -> Any:
    """Return the value of a scalar: a number, a truth value, None, a date or a text.

    Raises:
        YAMLError: Its tag is unknown, or its text does not fit the tag.
    """
    try:
        return SafeConstructor().construct_document(node)
    except ValueError:  # 2024-13-01 looks like a date
        return node.value
