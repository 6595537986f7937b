"""Type descriptions and their RIHS01 hashes, equal to ROS 2's (REP 2016)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.interfaces.spec import ActionSpec, Field, FieldType, MessageSpec, ServiceSpec

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.interfaces.spec import InterfaceSpec

#: Values of `FieldType.type_id` in type_description_interfaces. A .msg file's `char` is uint8.
TYPE_IDS = {
    "int8": 2,
    "uint8": 3,
    "char": 3,
    "int16": 4,
    "uint16": 5,
    "int32": 6,
    "uint32": 7,
    "int64": 8,
    "uint64": 9,
    "float32": 10,
    "float64": 11,
    "bool": 15,
    "byte": 16,
    "string": 17,
    "wstring": 18,
}
NESTED_ID = 1
#: Added to the id of a `string` or `wstring` with a bound.
BOUNDED_STRING = 4
#: Added to the id of the element type of an array or a sequence.
ARRAY, BOUNDED_SEQUENCE, SEQUENCE = 48, 96, 144
#: The field that ROS 2 adds to a message without fields, because a C structure cannot be empty.
EMPTY_MEMBER = Field("structure_needs_at_least_one_member", FieldType("uint8"))


def hash_of(spec: InterfaceSpec, get_spec: Callable[[str], InterfaceSpec]) -> str:
    """Return the type's hash: `RIHS01_` and 64 hexadecimal digits.

    Args:
        spec: The interface.
        get_spec: Function that returns the spec of a message inside the interface.
    """
    import hashlib  # noqa: PLC0415 - takes 4 ms with json; most commands need no hash
    import json  # noqa: PLC0415

    text = json.dumps(type_description(spec, get_spec))
    return f"RIHS01_{hashlib.sha256(text.encode()).hexdigest()}"


def type_description(
    spec: InterfaceSpec, get_spec: Callable[[str], InterfaceSpec]
) -> dict[str, Any]:
    """Return the description of a type and of all types inside it.

    It has the fields of `type_description_interfaces/msg/TypeDescription`. It has no default
    values, because they are not part of the hash.
    """
    seen: dict[str, dict[str, Any]] = {}
    waiting = [spec]
    while waiting:
        current = waiting.pop()
        if current.name not in seen:
            fields = _fields(current)
            seen[current.name] = _individual(current.name, fields)
            waiting += [get_spec(field.type.base) for field in fields if field.type.is_message]
    main = seen.pop(spec.name)
    return {
        "type_description": main,
        "referenced_type_descriptions": [seen[name] for name in sorted(seen)],
    }


def _fields(spec: InterfaceSpec) -> tuple[Field, ...]:
    if isinstance(spec, MessageSpec):
        return spec.fields or (EMPTY_MEMBER,)
    if isinstance(spec, ServiceSpec):
        parts: dict[str, MessageSpec | ServiceSpec] = {
            "request_message": spec.request,
            "response_message": spec.response,
            "event_message": spec.event,
        }
    else:
        parts = _action_parts(spec)
    return tuple(Field(name, FieldType(part.name)) for name, part in parts.items())


def _action_parts(spec: ActionSpec) -> dict[str, MessageSpec | ServiceSpec]:
    return {
        "goal": spec.goal,
        "result": spec.result,
        "feedback": spec.feedback,
        "send_goal_service": spec.send_goal,
        "get_result_service": spec.get_result,
        "feedback_message": spec.feedback_message,
    }


def _individual(name: str, fields: tuple[Field, ...]) -> dict[str, Any]:
    # The order of the keys matters, because the hash is computed from the JSON text.
    return {
        "type_name": name,
        "fields": [{"name": field.name, "type": _type(field.type)} for field in fields],
    }


def _type(field_type: FieldType) -> dict[str, Any]:
    type_id = TYPE_IDS.get(field_type.base, NESTED_ID)
    if field_type.string_bound:
        type_id += BOUNDED_STRING
    if field_type.kind == "array":
        type_id += ARRAY
    elif field_type.kind == "sequence":
        type_id += BOUNDED_SEQUENCE if field_type.size else SEQUENCE
    return {
        "type_id": type_id,
        "capacity": field_type.size,
        "string_capacity": field_type.string_bound,
        "nested_type_name": field_type.base if field_type.is_message else "",
    }
