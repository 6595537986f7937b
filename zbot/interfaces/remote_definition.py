"""Definitions that only another machine has, made from the type description that it sends."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.interfaces import derived, grammar
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
from zbot.interfaces.spec import Field, InterfaceSpec, MessageSpec, parts_of

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

# `char` has uint8's number: in a .msg file they are one type.
_BASES = {number: base for base, number in TYPE_IDS.items() if base != "char"}
_STRING_IDS = (TYPE_IDS["string"], TYPE_IDS["wstring"])


def register_description(description: Mapping[str, Any]) -> InterfaceSpec:
    """Make a type known, and all types inside it, from a description as `type_description` gives.

    Defaults, constants and comments are no part of a description: they are lost.

    Returns:
        The definition of the type itself.

    Raises:
        InterfaceSyntaxError: It is no valid description.
        InterfaceConflictError: A type has another definition here.
    """
    specs = specs_from(description)
    for spec in specs:
        register_spec(spec)
    return specs[-1]


def specs_from(description: Mapping[str, Any]) -> list[InterfaceSpec]:
    """Read the definitions out of a description, the type itself last; registers nothing.

    Raises:
        InterfaceSyntaxError: It is no valid description.
    """
    name = "type description"
    try:
        main = description["type_description"]
        name = str(main["type_name"])
        messages = {
            spec.name: spec for spec in map(_message, description["referenced_type_descriptions"])
        }
        last = _main(main, messages)
    except GrammarError as error:
        raise InterfaceSyntaxError(name, 0, "", str(error)) from error
    except (AttributeError, KeyError, TypeError, ValueError, RecursionError) as error:
        reason = f"this is no type description: {type(error).__name__}: {error}"
        raise InterfaceSyntaxError(name, 0, "", reason) from error
    # What belongs to a service or an action is registered with it.
    return [*(spec for spec in messages.values() if not spec.name.startswith(f"{name}_")), last]


def specs_from_sources(name: str, sources: Mapping[str, str]) -> list[InterfaceSpec]:
    """Read the definitions out of their texts, comments and constants too; registers nothing.

    Args:
        name: Full name of a type.
        sources: Its text and those of the types inside it, by their full names.

    Returns:
        The definitions, that of the type itself last.

    Raises:
        InterfaceSyntaxError: One of them is no valid definition.
    """
    # Importing zbot reads no definition, so it need not load what does.
    from zbot.interfaces.parser import parse  # noqa: PLC0415

    try:
        for one in sources:
            grammar.check_interface_name(one)
        others = [parse(one, text) for one, text in sources.items() if one != name]
        return [*others, parse(name, sources[name])]
    except GrammarError as error:
        raise InterfaceSyntaxError(name, 0, "", str(error)) from error
    except KeyError:
        raise InterfaceSyntaxError(name, 0, "", "its definition is not among the texts") from None


def hash_among(name: str, specs: Iterable[InterfaceSpec]) -> str:
    """Return the hash of a type, or of a part of one, that is defined by `specs`.

    Raises:
        UnknownPackageError: A type inside it is neither among them nor known here.
        UnknownInterfaceError: Likewise.
    """
    found: dict[str, InterfaceSpec] = {}
    waiting = list(specs)
    while waiting:
        spec = waiting.pop()
        found[spec.name] = spec
        waiting += parts_of(spec)

    def look_up(one: str) -> InterfaceSpec:
        return found[one] if one in found else get_spec(one)

    return hash_of(look_up(name), look_up)


def _main(main: Mapping[str, Any], messages: dict[str, MessageSpec]) -> InterfaceSpec:
    name = main["type_name"]
    grammar.check_interface_name(name)
    parts = {field["name"]: field["type"]["nested_type_name"] for field in main["fields"]}
    if name.split("/")[1] == "srv" and "request_message" in parts:
        return derived.service(
            name, messages[parts["request_message"]], messages[parts["response_message"]]
        )
    if "send_goal_service" in parts:
        goal, result, feedback = (messages[parts[key]] for key in ("goal", "result", "feedback"))
        return derived.action(name, goal, result, feedback)
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
    # The parser's own rules for names, sizes and bounds then hold for what comes from afar.
    return Field(field["name"], grammar.parse_type(text, "unused"))


def _element(type_id: int, kind: Mapping[str, Any]) -> str:
    """The type, or that of the elements, as a definition writes it."""
    if type_id == NESTED_ID:
        nested: str = kind["nested_type_name"]
        grammar.check_interface_name(nested)
        return nested
    if type_id - BOUNDED_STRING in _STRING_IDS:
        return f"{_BASES[type_id - BOUNDED_STRING]}<={int(kind['string_capacity'])}"
    if type_id not in _BASES:
        raise GrammarError(f"there is no type number {type_id}")
    return _BASES[type_id]
