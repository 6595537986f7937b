"""Definition of a type as `ros2 interface show` prints it, with the fields of nested types."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.interfaces import ActionSpec, ServiceSpec, get_spec
from zbot.interfaces.parser import split_comment

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.interfaces import Field, InterfaceSpec


def definition(
    spec: InterfaceSpec, *, comments: bool = True, nested_comments: bool = False
) -> Iterator[str]:
    """Yield the lines of a definition. Each level of nested types is indented by one more TAB.

    Args:
        spec: The definition.
        comments: Keep the comments and blank lines of the definition itself.
        nested_comments: Keep the comments and blank lines of nested types, if `comments` is true.
    """
    yield from _lines(spec, "", comments=comments, nested_comments=comments and nested_comments)


def _lines(
    spec: InterfaceSpec, indent: str, *, comments: bool, nested_comments: bool
) -> Iterator[str]:
    nested = {field.line: field.type.base for field in _fields(spec) if field.type.is_message}
    for number, line in enumerate(spec.text.rstrip("\n").splitlines(), start=1):
        code, _ = split_comment(line)
        if comments or code:
            yield (indent + (line if comments else code)).rstrip()
        if number in nested:
            inner = get_spec(nested[number])
            yield from _lines(
                inner, f"{indent}\t", comments=nested_comments, nested_comments=nested_comments
            )


def _fields(spec: InterfaceSpec) -> tuple[Field, ...]:
    if isinstance(spec, ServiceSpec):
        return spec.request.fields + spec.response.fields
    if isinstance(spec, ActionSpec):
        return spec.goal.fields + spec.result.fields + spec.feedback.fields
    return spec.fields
