"""Parser of .msg, .srv and .action files."""

from __future__ import annotations

import re
from typing import NamedTuple

from zbot.interfaces import grammar
from zbot.interfaces.errors import InterfaceSyntaxError
from zbot.interfaces.grammar import GrammarError
from zbot.interfaces.literal import parse_value
from zbot.interfaces.spec import (
    ActionSpec,
    Constant,
    Field,
    FieldType,
    InterfaceSpec,
    MessageSpec,
    ServiceSpec,
    action_spec,
    service_spec,
)

_SEPARATOR = "---"
# The text before the first `#` that is not in a quoted value. A quote begins a value only after a
# space, `=`, `,` or `[`, so an apostrophe inside a word does not begin a value.
_CODE = re.compile(r"""(?:(?<=[\s=,\[])(?:"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*')|[^#])*""")
_DECLARATION = re.compile(r"(?P<type>\S+)\s+(?P<name>[^\s=]+)\s*(?P<equals>=?)\s*(?P<value>.*)")


class _Source(NamedTuple):
    """One part of a file: the numbered lines, the package, and the file name for error messages."""

    package: str
    file: str
    lines: list[tuple[int, str]]


def split_comment(line: str) -> tuple[str, str]:
    """Return the code and the comment of a line. The comment starts with `#` or is empty."""
    match = _CODE.match(line)
    end = match.end() if match else 0
    return line[:end].rstrip(), line[end:]


def parse(name: str, text: str, file: str = "") -> InterfaceSpec:
    """Return the spec of a definition of any kind.

    Args:
        name: The full name of the interface, e.g. `std_srvs/srv/SetBool`.
        text: The definition.
        file: File name for error messages. If it is empty, error messages contain `name`.

    Raises:
        InterfaceSyntaxError: The definition breaks the grammar. The error has a line and advice.
    """
    source = _source(name, text, file)
    kind = name.split("/")[1]
    if kind == "srv":
        return _service(name, source, text)
    if kind == "action":
        return _action(name, source, text)
    return _message(name, source, text)


def parse_message(name: str, text: str, file: str = "") -> MessageSpec:
    """Return the spec in the text of a .msg file. See `parse`."""
    return _message(name, _source(name, text, file), text)


def parse_service(name: str, text: str, file: str = "") -> ServiceSpec:
    """Return the spec in the text of a .srv file. See `parse`."""
    return _service(name, _source(name, text, file), text)


def parse_action(name: str, text: str, file: str = "") -> ActionSpec:
    """Return the spec in the text of a .action file. See `parse`."""
    return _action(name, _source(name, text, file), text)


def _source(name: str, text: str, file: str) -> _Source:
    file = file or name
    try:
        package = grammar.check_interface_name(name)
        text.encode()
    except GrammarError as error:
        raise InterfaceSyntaxError(file, 0, "", str(error)) from None
    except UnicodeEncodeError as error:
        reason = "the text has characters that UTF-8 cannot hold"
        raise InterfaceSyntaxError(file, 0, "", reason) from error
    lines = text.removeprefix("\ufeff").splitlines()
    return _Source(package, file, list(enumerate(lines, start=1)))


def _service(name: str, source: _Source, text: str) -> ServiceSpec:
    request, response = _parts(source, "service", ("request", "response"))
    return service_spec(
        name,
        _message(f"{name}_Request", request),
        _message(f"{name}_Response", response),
        text,
    )


def _action(name: str, source: _Source, text: str) -> ActionSpec:
    goal, result, feedback = _parts(source, "action", ("goal", "result", "feedback"))
    return action_spec(
        name,
        _message(f"{name}_Goal", goal),
        _message(f"{name}_Result", result),
        _message(f"{name}_Feedback", feedback),
        text,
    )


def _parts(source: _Source, kind: str, names: tuple[str, ...]) -> list[_Source]:
    """Return the parts between the `---` lines. There is one part for each name."""
    parts: list[list[tuple[int, str]]] = [[]]
    for number, line in source.lines:
        if line.rstrip() == _SEPARATOR:
            parts.append([])
        else:
            parts[-1].append((number, line))
    if len(parts) != len(names):
        reason = (
            f"{_counted(len(names) - 1)} needed between {', '.join(names[:-1])} and {names[-1]} "
            f"of a{'n' if kind == 'action' else ''} {kind}, but there {_are(len(parts) - 1)}"
        )
        raise InterfaceSyntaxError(source.file, 0, "", reason)
    return [_Source(source.package, source.file, lines) for lines in parts]


def _counted(count: int) -> str:
    return f"one line {_SEPARATOR!r} is" if count == 1 else f"{count} lines {_SEPARATOR!r} are"


def _are(count: int) -> str:
    return "is one" if count == 1 else f"are {count or 'none'}"


def _message(name: str, source: _Source, text: str | None = None) -> MessageSpec:
    fields: dict[str, Field] = {}
    constants: dict[str, Constant] = {}
    for number, line in source.lines:
        code = split_comment(line)[0].strip()
        if not code:
            continue
        try:
            declared = _declaration(code, source.package, number)
            _add(declared, fields if isinstance(declared, Field) else constants)
        except GrammarError as error:
            raise InterfaceSyntaxError(source.file, number, line, str(error)) from None
    if text is None:
        text = "\n".join(line for _, line in source.lines)
    return MessageSpec(name, tuple(fields.values()), tuple(constants.values()), text)


def _declaration(code: str, package: str, number: int) -> Field | Constant:
    match = _DECLARATION.fullmatch(code)
    if match is None:
        raise GrammarError(_not_a_declaration_reason(code))
    type_text, name, equals, value = match.groups()
    field_type = grammar.parse_type(type_text, package)
    if equals:
        return _constant(field_type, name, value, number)
    grammar.check_field_name(name)
    default = parse_value(field_type, value) if value else None
    return Field(name, field_type, default, number)


def _constant(field_type: FieldType, name: str, value: str, number: int) -> Constant:
    if field_type.kind != "scalar" or field_type.is_message:
        raise GrammarError("a constant is a number, a bool or a string, not an array or a message")
    grammar.check_constant_name(name, value)
    parsed = parse_value(field_type, value)
    if isinstance(parsed, tuple):  # only the value of an array is a tuple
        raise GrammarError("a constant holds one value")
    return Constant(name, field_type, parsed, number)


def _add(declared: Field | Constant, known: dict[str, Field] | dict[str, Constant]) -> None:
    first = known.get(declared.name)
    if first is not None:
        raise GrammarError(f"{declared.name!r} is already declared in line {first.line}")
    known[declared.name] = declared  # type: ignore[assignment] # the caller picked the dict by type


def _not_a_declaration_reason(code: str) -> str:
    if code.startswith(_SEPARATOR):
        return f"only .srv and .action files have {_SEPARATOR!r} lines, with exactly three dashes"
    if code.endswith((";", ":")):
        return "a line is '<type> <name>', without punctuation after it"
    return "a line is '<type> <name>', e.g. 'float64 speed', but this line has only one word"
