"""C program that compares a generated header with zbot's CDR, for random messages."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path
from random import Random
from typing import TYPE_CHECKING, Any

import pytest

from tests.unit.wire.random_message import ALPHABET, random_message
from zbot.interfaces import get_interface, message_spec_of
from zbot.wire.cdr.codec import cdr_codec_for
from zbot.wire.embedded.c_header import c_header
from zbot.wire.embedded.c_literal import literal, member_name, type_name, wide_units
from zbot.wire.embedded.included_types import interfaces_of, messages_of

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from zbot.interfaces.spec import FieldType, MessageSpec

_FLAGS = ("-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic")
#: Each character is one byte, because the bounds of texts are bytes in C.
_ASCII = 'az_/ 09\n"\\?'
_SETTINGS = "#define ZBOT_CDR_CAPACITY 4\n#define ZBOT_CDR_TEXT_CAPACITY 160\n"


def compiled(folder: Path, *sources: Path, flags: Sequence[str] = ()) -> Path:
    """Return a program that gcc has compiled without a warning. Skip the test without gcc."""
    gcc = shutil.which("gcc")
    if gcc is None:
        pytest.skip("gcc is not installed, so C headers cannot be compiled")
    program = folder / "program"
    command = [gcc, *_FLAGS, *flags, f"-I{folder}", *map(str, sources), "-o", str(program)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[:4000]
    return program


def differences(folder: Path, names: Sequence[str]) -> str:
    """Compare all messages of these interfaces. Return the output of the program."""
    specs = messages_of(interfaces_of(names))
    (folder / "messages.h").write_text(_SETTINGS + c_header(names), encoding="ascii")
    random = Random(33)
    messages = [_message(spec, random) for spec in specs]
    (folder / "types.inc").write_text("\n".join(_types(specs, messages)), encoding="ascii")
    with (folder / "expected").open("wb") as file:
        for message in messages:
            for each in (message, type(message)()):
                data = cdr_codec_for(type(message)).encode(each)
                file.write(len(data).to_bytes(4, "little") + data)
    program = compiled(folder, Path(__file__).with_name("c_check.c"))
    done = subprocess.run(
        [program, folder / "expected"], capture_output=True, text=True, check=False
    )
    return done.stdout or f"exit code {done.returncode}"


def _message(spec: MessageSpec, random: Random) -> Any:
    alphabet = _ASCII if _has_bounded_text(spec) else ALPHABET.replace("\0", "")
    return random_message(get_interface(spec.name), random, alphabet)


def _has_bounded_text(spec: MessageSpec) -> bool:
    return any(
        kind.string_bound
        or (kind.is_message and _has_bounded_text(message_spec_of(get_interface(kind.base))))
        for kind in (field.type for field in spec.fields)
    )


def _types(specs: Sequence[MessageSpec], messages: Sequence[Any]) -> Iterator[str]:
    for spec, message in zip(specs, messages, strict=True):
        name = type_name(spec.name)
        yield f"TYPE({name})"
        yield f"static void {name}_f(void *any)\n{{\n    {name} *message = ({name} *)any;"
        yield from _assignments(spec, message, "message->")
        yield "    (void)message;\n}\n"
    yield "static const type types[] = {"
    yield from (f"ENTRY({type_name(spec.name)})" for spec in specs)
    yield "};"


def _assignments(spec: MessageSpec, message: Any, path: str) -> Iterator[str]:
    for field in spec.fields:
        target, value = path + member_name(field.name), getattr(message, field.name)
        if field.type.kind == "scalar":
            yield from _assignment(field.type, target, value)
            continue
        if field.type.kind == "sequence":
            yield f"    {target}.size = {len(value)};"
            target += ".data"
        for number, item in enumerate(value):
            yield from _assignment(field.type, f"{target}[{number}]", item)


def _assignment(kind: FieldType, target: str, value: Any) -> Iterator[str]:
    if kind.is_message:
        yield from _assignments(message_spec_of(get_interface(kind.base)), value, f"{target}.")
    elif kind.base == "wstring":
        yield f"    {target}.size = {len(wide_units(value))};"
        for number, unit in enumerate(wide_units(value)):
            yield f"    {target}.data[{number}] = {unit};"
    elif kind.base == "string":
        yield f"    strcpy({target}, {literal(kind, value)});"
    else:
        yield f"    {target} = {literal(kind, value)};"
