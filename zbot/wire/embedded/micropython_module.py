"""MicroPython module with the messages of some interfaces. It imports only `struct`."""

from __future__ import annotations

import keyword
import math
import re
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.interfaces import type_hash
from zbot.interfaces.spec import MessageSpec, ServiceSpec
from zbot.wire.embedded.included_types import interfaces_of, messages_of
from zbot.wire.rmw_zenoh import dds_type

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from zbot.interfaces.spec import Field, InterfaceSpec, Scalar

_TITLE = '''\
"""Messages of ROS 2 for MicroPython. This file was written by the command

    zbot interface header {names} --micropython

    data = write(message)         returns the message as bytes (CDR)
    message = read(Name, data)    returns the message of a class that the bytes contain

Both raise CdrError if a value or the bytes are wrong.
"""
'''
_FUNCTIONS = '''\
def write(message):
    """Return a message as bytes (CDR)."""
    cdr = CdrWriter()
    message._put(cdr)
    return bytes(cdr.data)


def read(message_class, data):
    """Return the message of a class that bytes contain. More bytes after it are ignored."""
    return _message(message_class, CdrReader(data))


def _message(message_class, cdr):
    message = message_class()
    message._get(cdr)
    return message
'''
_OWN_NAMES = frozenset({"TYPE_NAME", "DDS_NAME", "TYPE_HASH"})
_BYTE_TYPES = frozenset({"uint8", "char", "byte"})


def micropython_module(names: Iterable[str]) -> str:
    """Return the source of a module with the classes of messages, services and actions.

    Args:
        names: Full names, e.g. `std_msgs/msg/String` or `std_srvs/srv/SetBool`.

    Raises:
        UnknownPackageError: A package does not exist here.
        UnknownInterfaceError: A package has no such interface.
        InterfaceSyntaxError: A definition is wrong.
    """
    interfaces = interfaces_of(names)
    messages = messages_of(interfaces)
    classes = _class_names([*messages, *interfaces])
    text = Path(__file__).with_name("cdr_module.py").read_text(encoding="utf-8")
    text = re.sub(r"  # noqa.*", "", text)
    lines = [_TITLE.format(names=" ".join(spec.name for spec in interfaces))]
    lines += [text.partition('"""\n\n')[2], "", _FUNCTIONS]
    for message in messages:
        lines += _message_class(message, classes)
    for spec in interfaces:
        lines += _interface_class(spec, classes)
    return "\n".join(lines)


def _class_names(specs: Iterable[InterfaceSpec]) -> dict[str, str]:
    """Return the name of each class. It is the type's name, or the full name if it must be."""
    short: dict[str, set[str]] = {}
    for spec in specs:
        short.setdefault(spec.name.rpartition("/")[2], set()).add(spec.name)
    return {
        name: base if len(full) == 1 else name.replace("/", "_")
        for base, full in short.items()
        for name in full
    }


def _interface_class(spec: InterfaceSpec, classes: dict[str, str]) -> Iterator[str]:
    """Yield the class of a service or an action. Its attributes are the classes of its messages."""
    if isinstance(spec, MessageSpec):
        return
    parts: dict[str, InterfaceSpec]
    if isinstance(spec, ServiceSpec):
        parts = {"Request": spec.request, "Response": spec.response}
    else:
        parts = {"Goal": spec.goal, "Result": spec.result, "Feedback": spec.feedback}
    yield from ("", f"class {classes[spec.name]}:", *_names(spec.name))
    yield from (f"    {name} = {classes[part.name]}" for name, part in parts.items())
    yield ""


def _names(name: str) -> list[str]:
    """Return the lines that define the names and the hash of an interface."""
    texts = {"TYPE_NAME": name, "DDS_NAME": dds_type(name), "TYPE_HASH": type_hash(name)}
    return [f'    {end} = "{text}"' for end, text in texts.items()]


def _message_class(spec: MessageSpec, classes: dict[str, str]) -> Iterator[str]:
    yield from ("", f"class {classes[spec.name]}:", *_names(spec.name))
    for constant in spec.constants:
        end = "_" if constant.name in _OWN_NAMES else ""
        yield f"    {constant.name}{end} = {_constant(constant.value)}"
    fields = [_FieldSource(field, classes) for field in spec.fields]
    yield from ("", f"    def __init__(self{''.join(f.parameter for f in fields)}):")
    yield from [f"        {f.assignment}" for f in fields] or ["        pass"]
    yield from ("", "    def _put(self, cdr):")
    yield from [f"        {f.put}" for f in fields] or ['        cdr.number("B", 0)']
    yield from ("", "    def _get(self, cdr):")
    yield from [f"        {f.get}" for f in fields] or ['        cdr.number("B")']
    yield ""


def _constant(value: Scalar) -> str:
    """Return the literal of a value. MicroPython has no names for numbers that are not finite."""
    if isinstance(value, bytes):
        return str(value[0])
    if isinstance(value, float) and not math.isfinite(value):
        return f'float("{value}")'
    return ascii(value)


class _FieldSource:
    """Python source of one field: its parameter, its default value, and how it is put and got."""

    def __init__(self, field: Field, classes: dict[str, str]) -> None:
        self._kind = field.type
        self._name = f"{field.name}_" if keyword.iskeyword(field.name) else field.name
        self._class = classes.get(field.type.base, "")
        self._default = field.default

    @property
    def _is_octets(self) -> bool:
        return self._kind.base in _BYTE_TYPES and self._kind.kind != "scalar"

    @property
    def _is_constant(self) -> bool:
        """Whether the default value cannot change, so that it can stand in the parameter."""
        return not self._class and (self._kind.kind == "scalar" or self._is_octets)

    @property
    def parameter(self) -> str:
        return f", {self._name}={self._value if self._is_constant else None}"

    @property
    def assignment(self) -> str:
        if self._is_constant:
            return f"self.{self._name} = {self._name}"
        return f"self.{self._name} = {self._value} if {self._name} is None else {self._name}"

    @property
    def _value(self) -> str:
        default = self._default
        if isinstance(default, tuple):
            if self._is_octets:
                return repr(b"".join(map(_octet, default)))
            return f"[{', '.join(map(_constant, default))}]"
        if default is not None:
            return _constant(default)
        if self._kind.kind == "sequence":
            return 'b""' if self._is_octets else "[]"
        if self._kind.kind == "scalar":
            return self._zero
        if self._is_octets:
            return f"bytes({self._kind.size})"
        if self._class:
            return f"[{self._zero} for _ in range({self._kind.size})]"
        return f"[{self._zero}] * {self._kind.size}"

    @property
    def _zero(self) -> str:
        if self._class:
            return f"{self._class}()"
        if self._kind.is_string:
            return '""'
        if self._kind.base == "bool":
            return "False"
        return "0.0" if self._kind.typecode and self._kind.typecode in "fd" else "0"

    @property
    def _limits(self) -> str:
        """Arguments: the length of an array or -1, and the bound of a sequence or 0."""
        if self._kind.kind == "array":
            return f"{self._kind.size}, 0"
        return f"-1, {self._kind.size}"

    @property
    def put(self) -> str:
        value = f"self.{self._name}"
        if self._kind.kind == "scalar":
            return self._put_one(value)
        if self._is_octets:
            return f"cdr.octets({value}, {self._limits})"
        if self._kind.typecode:
            return f'cdr.numbers("{self._kind.typecode}", {value}, {self._limits})'
        return (
            f"cdr.count(len({value}), {self._limits})\n"
            f"        for item in {value}:\n"
            f"            {self._put_one('item')}"
        )

    def _put_one(self, value: str) -> str:
        if self._class:
            return f"{value}._put(cdr)"
        if self._kind.is_string:
            verb = "text" if self._kind.base == "string" else "wide_text"
            return f"cdr.{verb}({value}, {self._kind.string_bound})"
        if self._kind.base == "bool":
            return f'cdr.number("B", 1 if {value} else 0)'
        return f'cdr.number("{self._kind.typecode or "B"}", {value})'

    @property
    def get(self) -> str:
        return f"self.{self._name} = {self._got}"

    @property
    def _got(self) -> str:
        if self._kind.kind == "scalar":
            return self._get_one
        if self._is_octets:
            return f"cdr.octets({self._limits})"
        if self._kind.typecode:
            return f'cdr.numbers("{self._kind.typecode}", {self._limits})'
        return f"[{self._get_one} for _ in range(cdr.count({self._limits}))]"

    @property
    def _get_one(self) -> str:
        if self._class:
            return f"_message({self._class}, cdr)"
        if self._kind.is_string:
            verb = "text" if self._kind.base == "string" else "wide_text"
            return f"cdr.{verb}({self._kind.string_bound})"
        if self._kind.base == "bool":
            return 'cdr.number("B") != 0'
        return f'cdr.number("{self._kind.typecode or "B"}")'


def _octet(value: Scalar) -> bytes:
    return value if isinstance(value, bytes) else bytes((int(value),))
