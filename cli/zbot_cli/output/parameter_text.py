"""Parameters as text: as `zbot param` prints them, and as a parameter file."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.interfaces import yaml_text
from zbot.parameters.file import matches
from zbot.parameters.parameter import PARAMETER_SEPARATOR_STRING, Parameter, get_parameter_value
from zbot.parameters.value_text import with_quotes

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence


def message_of(name: str, text: str) -> Any:
    """Return a parameter as a message. The text of the value decides the parameter's type."""
    from rcl_interfaces.msg import Parameter as Message  # noqa: PLC0415 - the import makes the class

    return Message(name=name, value=get_parameter_value(text))


def shown(parameter: Parameter[Any], *, hide_type: bool) -> str:
    """Return the text that ros2 prints for a parameter: the type and then the value."""
    kind = parameter.type_
    if kind is Parameter.Type.NOT_SET:
        return "Parameter not set."
    if hide_type:
        return str(parameter.value)
    word = kind.text.split()[0].capitalize()
    return f"{word} {'values are' if kind.is_array else 'value is'}: {parameter.value}"


def plain_values(found: Mapping[str, Parameter[Any]]) -> dict[str, Any]:
    """Return values for JSON and YAML, with bytes as integers."""
    return {name: _plain(parameter) for name, parameter in found.items()}


def _plain(parameter: Parameter[Any]) -> Any:
    if parameter.type_ is Parameter.Type.BYTE_ARRAY:
        return [item[0] for item in parameter.value]
    return parameter.value


# -- describing --------------------------------------------------------------------------------


def description(descriptor: Any) -> dict[str, Any]:
    """Return a descriptor's fields, without texts that are empty."""
    limits = (*descriptor.integer_range, *descriptor.floating_point_range)
    facts = {
        "name": descriptor.name,
        "type": Parameter.Type(descriptor.type).text,
        "description": descriptor.description,
        "additional_constraints": descriptor.additional_constraints,
        "read_only": descriptor.read_only,
        "dynamic_typing": descriptor.dynamic_typing,
    }
    for value_range in limits[:1]:
        facts |= {
            "min": value_range.from_value,
            "max": value_range.to_value,
            "step": value_range.step,
        }
    return {key: value for key, value in facts.items() if value != ""}


def description_lines(descriptor: Any) -> Iterator[str]:
    """Yield a descriptor's lines, as ros2 prints them."""
    yield f"Parameter name: {descriptor.name}"
    yield f"  Type: {Parameter.Type(descriptor.type).text}"
    if descriptor.description:
        yield f"  Description: {descriptor.description}"
    yield "  Constraints:"
    if descriptor.read_only:
        yield "    Read only: true"
    for limits in (*descriptor.integer_range, *descriptor.floating_point_range):
        yield f"    Min value: {limits.from_value}"
        yield f"    Max value: {limits.to_value}"
        if limits.step:
            yield f"    Step: {limits.step}"
    if descriptor.additional_constraints:
        yield f"    Additional constraints: {descriptor.additional_constraints}"


# -- files -------------------------------------------------------------------------------------


def file_text(values: Mapping[str, Mapping[str, Parameter[Any]]]) -> str:
    """Return the text of a parameter file for nodes, without the parameters that have no value."""
    return yaml_text.dump(
        {
            node: {
                "ros__parameters": _tree(
                    {
                        name: with_quotes(_plain(parameter))
                        for name, parameter in sorted(found.items())
                        if parameter.type_ is not Parameter.Type.NOT_SET
                    }
                )
            }
            for node, found in values.items()
        }
    )


def _tree(values: dict[str, Any]) -> dict[str, Any]:
    """Return dotted names as nested groups. A name stays dotted if its prefix has a value too."""
    tree: dict[str, Any] = {}
    for name, value in values.items():
        *groups, last = name.split(PARAMETER_SEPARATOR_STRING)
        branch = tree
        for group in groups:
            below = branch.setdefault(group, {})
            if not isinstance(below, dict):
                branch, last = tree, name
                break
            branch = below
        branch[last] = value
    return dict(_sorted(tree))


def _sorted(tree: dict[str, Any]) -> Iterator[tuple[str, Any]]:
    for name, value in sorted(tree.items()):
        yield name, dict(_sorted(value)) if isinstance(value, dict) else value


def values_for(
    content: Sequence[tuple[str, dict[str, Any]]], node: str, *, use_wildcards: bool
) -> dict[str, Any]:
    """Return a file's values for a node. Values under the node's own name override wildcards."""
    groups = [
        (pattern, values)
        for pattern, values in content
        if matches(pattern, node) and (use_wildcards or "*" not in pattern)
    ]
    groups.sort(key=lambda group: "*" not in group[0])
    return {name: value for _, values in groups for name, value in values.items()}
