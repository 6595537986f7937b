"""YAML writer in ros2's format, and values of YAML nodes, both based on PyYAML."""

from __future__ import annotations

from typing import Any

import yaml
from yaml import CollectionNode, MappingNode, Node, ScalarNode, SequenceNode

from zbot.text.yaml_reader import YamlError, compose_yaml, construct_yaml

__all__ = [
    "CollectionNode",
    "Flow",
    "MappingNode",
    "Node",
    "Quoted",
    "ScalarNode",
    "SequenceNode",
    "YamlError",
    "compose",
    "dump",
    "scalar",
]

# libyaml is ten times faster. A PyYAML that was built without libyaml does not have these names.
_BaseDumper: Any = getattr(yaml, "CSafeDumper", yaml.SafeDumper)
_UNLIMITED = 2**31 - 1
# PyYAML's own emitter writes these line breaks in a form that cannot be read again.
_UNUSUAL_BREAKS = frozenset("\x85\u2028\u2029")


class Flow(list[Any]):
    """A list that is written on one line."""


class Quoted(str):
    """A string that is written in quotes, so that it is always read as a string."""

    __slots__ = ()


def _represent_quoted(dumper: Any, data: Quoted) -> Any:
    return dumper.represent_scalar("tag:yaml.org,2002:str", str(data), style="'")


def _represent_flow(dumper: Any, data: Flow) -> Any:
    return dumper.represent_sequence("tag:yaml.org,2002:seq", data, flow_style=True)


class _Dumper(_BaseDumper):  # type: ignore[misc]
    """Dumper that writes every value in full, even if the value occurs twice."""

    def ignore_aliases(self, data: object) -> bool:  # noqa: ARG002 - PyYAML's signature
        return True


class _WideDumper(yaml.SafeDumper):
    """Slower dumper for emoji and other characters above U+FFFF, which libyaml would escape."""

    def ignore_aliases(self, data: object) -> bool:  # noqa: ARG002 - PyYAML's signature
        return True


_Dumper.add_representer(Flow, _represent_flow)
_WideDumper.add_representer(Flow, _represent_flow)
_Dumper.add_representer(Quoted, _represent_quoted)
_WideDumper.add_representer(Quoted, _represent_quoted)


def dump(value: Any, *, flow_style: bool = False) -> str:
    """Return plain values as YAML with a final newline. `flow_style` writes one line."""
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
    """Return the node of the only document in a text. Return None if the text is empty.

    Raises:
        YamlError: The text is not YAML, contains several documents, or is too large or too deep.
    """
    node: Node | None = compose_yaml(text)
    return node


def scalar(node: ScalarNode) -> Any:
    """Return the value of a scalar: a number, a bool, None, a date or a string.

    Raises:
        YamlError: The tag is unknown or not for scalars, or a `!!binary` text is not base64.
    """
    try:
        return construct_yaml(node)
    except YamlError as error:
        if error.line is None:  # e.g. for 2024-13-01, !!bool x, !!timestamp x
            return node.value
        raise
