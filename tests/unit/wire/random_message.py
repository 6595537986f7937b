"""Messages with random values, and the names of all message types that zbot has."""

from __future__ import annotations

import functools
import math
from random import Random
from typing import Any

from zbot.interfaces import (
    MessageSpec,
    ServiceSpec,
    get_interface,
    get_spec,
    interface_names,
    spec_of,
)
from zbot.interfaces.location import shipped_packages
from zbot.interfaces.spec import INTEGER_RANGES, FieldType

ALPHABET = "az_/ 09é€\U0001f916\n\x00"


#: Elements of a list. Lists in lists are shorter: a type of MoveIt would have megabytes otherwise.
_LONGEST = 3


def random_message(
    message_class: type[Any], random: Random, alphabet: str = ALPHABET, longest: int = _LONGEST
) -> Any:
    spec = spec_of(message_class)
    assert isinstance(spec, MessageSpec)
    values = {field.name: _value(field.type, random, alphabet, longest) for field in spec.fields}
    return message_class(**values)


@functools.cache
def message_of(name: str) -> Any:
    """Return a random message of a type: the same one to all tests of this process."""
    return random_message(get_interface(name), Random(name))


def _value(kind: FieldType, random: Random, alphabet: str, longest: int) -> Any:
    if kind.kind == "scalar":
        return _scalar(kind, random, alphabet, longest)
    most = min(kind.size or longest, longest)
    length = kind.size if kind.kind == "array" else random.randint(0, most)
    inner = max(longest - 1, 0) if kind.is_message else longest
    return [_scalar(kind, random, alphabet, inner) for _ in range(length)]


def _scalar(kind: FieldType, random: Random, alphabet: str, longest: int) -> Any:
    if kind.is_message:
        return random_message(get_interface(kind.base), random, alphabet, longest)
    if kind.base in INTEGER_RANGES:
        low, high = INTEGER_RANGES[kind.base]
        return random.choice([low, high, random.randint(low, high), max(low, 0)])
    if kind.base == "float32":
        return random.choice([0.0, -1.5, 2.0**100, math.inf, -math.inf])
    if kind.base == "float64":
        return random.choice([0.0, -0.1, random.uniform(-1e300, 1e300), math.inf])
    if kind.base == "bool":
        return random.random() < 0.5
    if kind.base == "byte":
        return bytes((random.randint(0, 255),))
    return "".join(random.choices(alphabet, k=random.randint(0, min(kind.string_bound or 40, 40))))


def shipped_messages() -> list[str]:
    names = []
    for package in shipped_packages():
        for name in interface_names(package):
            spec = get_spec(name)
            if isinstance(spec, MessageSpec):
                names.append(name)
            elif isinstance(spec, ServiceSpec):
                names += [spec.request.name, spec.response.name, spec.event.name]
            else:
                parts = (spec.goal, spec.result, spec.feedback, spec.feedback_message)
                names += [part.name for part in parts]
                names += [spec.send_goal.request.name, spec.get_result.response.name]
    return names
