"""Definitions from other machines. They are made from type descriptions that the machines send."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.interfaces import grammar
from zbot.interfaces.definition_limits import (
    check_field_limits,
    check_limits,
    check_text_limits,
    with_parts,
)
from zbot.interfaces.description import (
    ARRAY,
    BOUNDED_SEQUENCE,
    BOUNDED_STRING,
    EMPTY_MEMBER,
    NESTED_ID,
    SEQUENCE,
    TYPE_IDS,
    hash_of,
)
from zbot.interfaces.errors import InterfaceSyntaxError
from zbot.interfaces.grammar import GrammarError
from zbot.interfaces.registry import get_spec, register_spec
from zbot.interfaces.spec import Field, InterfaceSpec, MessageSpec, action_spec, service_spec

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

# `char` has the number of uint8, because both are the same type in a .msg file.
_BASES = {number: base for base, number in TYPE_IDS.items() if base != "char"}
_STRING_IDS = (TYPE_IDS["string"], TYPE_IDS["wstring"])


def register_description(description: Mapping[str, Any]) -> InterfaceSpec:
    """Register a type and all types inside it. `description` is a result of `type_description()`.

    The definition has no defaults, constants and comments, because a description does not contain
    them.

    Returns:
        The definition of the type itself.

    Raises:
        InterfaceSyntaxError: The description is not valid.
        DefinitionLimitError: A message of the type would be too large.
        WrongValueError: A type has another definition here.
        UnknownPackageError: The description lacks a type, and its package is not known here.
        UnknownInterfaceError: The description lacks a type, and its known package lacks it too.
    """
    specs = specs_from(description)
    check_limits(specs)
    for spec in specs:
        register_spec(spec)
    return specs[-1]


def specs_from(description: Mapping[str, Any]) -> list[InterfaceSpec]:
    """Return the definitions in a description without registering them. The type itself is last.

    Raises:
        InterfaceSyntaxError: The description is not valid.
    """
    name = "type description"
    try:
        main = description["type_description"]
        name = str(main["type_name"])
        others = description["referenced_type_descriptions"]
        check_field_limits(name, [len(part["fields"]) for part in (main, *others)])
        messages = {spec.name: spec for spec in map(_message, others)}
        last = _main(main, messages)
    except GrammarError as error:
        raise InterfaceSyntaxError(name, 0, "", str(error)) from error
    except InterfaceSyntaxError:
        raise
    except (AttributeError, KeyError, TypeError, ValueError, RecursionError) as error:
        reason = f"the type description is not valid: {type(error).__name__}: {error}"
        raise InterfaceSyntaxError(name, 0, "", reason) from error
    # The parts of a service or an action are registered together with it.
    return [*(spec for spec in messages.values() if not spec.name.startswith(f"{name}_")), last]


def specs_from_sources(name: str, sources: Mapping[str, str]) -> list[InterfaceSpec]:
    """Return the definitions in texts, with comments and constants, without registering them.

    Args:
        name: Full name of a type.
        sources: The texts of the type and of the types inside it, by full name.

    Returns:
        The definitions. The definition of the type itself is the last.

    Raises:
        InterfaceSyntaxError: A text is not a valid definition.
    """
    # `import zbot` reads no definitions, so it does not need the parser.
    from zbot.interfaces.parser import parse  # noqa: PLC0415

    check_text_limits(name, sources.values())
    try:
        for other in sources:
            grammar.check_interface_name(other)
        others = [parse(other, text) for other, text in sources.items() if other != name]
        return [*others, parse(name, sources[name])]
    except GrammarError as error:
        raise InterfaceSyntaxError(name, 0, "", str(error)) from error
    except KeyError:
        raise InterfaceSyntaxError(name, 0, "", "its definition is not among the texts") from None


def hash_among(name: str, specs: Iterable[InterfaceSpec]) -> str:
    """Return the hash of a type, or of a part of a type, that is defined by `specs`.

    Raises:
        UnknownPackageError: A type inside it is missing in `specs`, and its package is unknown.
        UnknownInterfaceError: A type inside it is missing in `specs` and in its known package.
    """
    found = with_parts(specs)

    def look_up(type_name: str) -> InterfaceSpec:
        return found[type_name] if type_name in found else get_spec(type_name)

    return hash_of(look_up(name), look_up)


def _main(main: Mapping[str, Any], messages: dict[str, MessageSpec]) -> InterfaceSpec:
    name = main["type_name"]
    grammar.check_interface_name(name)
    parts = {field["name"]: field["type"]["nested_type_name"] for field in main["fields"]}
    if name.split("/")[1] == "srv" and "request_message" in parts:
        return service_spec(
            name, messages[parts["request_message"]], messages[parts["response_message"]]
        )
    if "send_goal_service" in parts:
        goal, result, feedback = (messages[parts[key]] for key in ("goal", "result", "feedback"))
        return action_spec(name, goal, result, feedback)
    return _message(main)


def _message(individual: Mapping[str, Any]) -> MessageSpec:
    name = individual["type_name"]
    grammar.check_interface_name(name)
    fields = tuple(map(_field, individual["fields"]))
    if fields == (EMPTY_MEMBER,):
        fields = ()
    if len({field.name for field in fields}) != len(fields):
        raise GrammarError("two fields have the same name")
    text = "".join(f"{field.type.text} {field.name}\n" for field in fields)
    return MessageSpec(name, fields, text=text)


def _field(field: Mapping[str, Any]) -> Field:
    grammar.check_field_name(field["name"])
    kind = field["type"]
    type_id, size = int(kind["type_id"]), int(kind["capacity"])
    for offset in (SEQUENCE, BOUNDED_SEQUENCE, ARRAY, 0):
        if type_id > offset:
            text = _element(type_id - offset, kind)
            break
    else:
        raise GrammarError(f"there is no type number {type_id}")
    if offset:
        text += {SEQUENCE: "[]", BOUNDED_SEQUENCE: f"[<={size}]", ARRAY: f"[{size}]"}[offset]
    # `parse_type` checks names, sizes and bounds with the rules for definition files.
    return Field(field["name"], grammar.parse_type(text, "unused"))


def _element(type_id: int, kind: Mapping[str, Any]) -> str:
    """Return a type as a definition writes it. For an array, return the type of the elements."""
    if type_id == NESTED_ID:
        nested: str = kind["nested_type_name"]
        grammar.check_interface_name(nested)
        return nested
    if type_id - BOUNDED_STRING in _STRING_IDS:
        return f"{_BASES[type_id - BOUNDED_STRING]}<={int(kind['string_capacity'])}"
    if type_id not in _BASES:
        raise GrammarError(f"there is no type number {type_id}")
    return _BASES[type_id]
