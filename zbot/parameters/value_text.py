"""Writer of parameter values as YAML from which ROS 2 reads the same value and the same type."""

from __future__ import annotations

from typing import Any

from zbot.parameters.errors import ParameterValueError
from zbot.parameters.file import parse_value


def value_text(value: Any) -> str:
    """Return a value as YAML in one line, without the newline at its end.

    A string that contains line breaks becomes several lines.
    """
    from zbot.interfaces import yaml_text  # noqa: PLC0415 - takes 15 ms, and few programs need it

    text = yaml_text.dump(with_quotes(value), flow_style=True)
    return text.removesuffix("\n").removesuffix("\n...")


def with_quotes(value: Any) -> Any:
    """Return a value that `yaml_text.dump` writes with the necessary quotes.

    YAML's own rules are not sufficient: for ROS 2, `1e3`, `nan` and `y` are not strings.
    """
    from zbot.interfaces import yaml_text  # noqa: PLC0415 - as above

    if isinstance(value, (list, tuple)):
        return [with_quotes(item) for item in value]
    if not isinstance(value, str):
        return value
    try:
        is_plain = parse_value(value) == value
    except ParameterValueError:
        is_plain = False
    return str(value) if is_plain else yaml_text.Quoted(value)
