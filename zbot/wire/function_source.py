"""Python source of one function, written line by line, and its compilation."""

from __future__ import annotations

from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from zbot.interfaces import get_interface, message_spec_of

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from zbot.interfaces.spec import FieldType, MessageSpec

# If a type has more fields at all levels, its source calls a function for each message inside it.
# Without this limit, the source of some types would be very long, and slow to compile.
_MAX_FIELDS = 250
_MAX_LOOPS = 8  # Python allows 20 nested blocks


class FunctionSource:
    """Lines of a function, and the values of the names in them."""

    def __init__(self) -> None:
        self.names: dict[str, Any] = {}  #: values of the names in the source
        self.called: dict[str, type[Any]] = {}  #: classes of inner messages by function name
        self.lines: list[str] = []
        self._indentation = 1
        self._last_number = 0

    def add(self, line: str) -> None:
        """Add a line."""
        self.lines.append("    " * self._indentation + line)

    @contextmanager
    def block(self, header: str) -> Iterator[None]:
        """Add a line that begins a block. The lines added in the context belong to the block."""
        self.add(header)
        self._indentation += 1
        yield
        self._indentation -= 1

    def fresh(self, prefix: str) -> str:
        """Return a name that the source does not have yet."""
        self._last_number += 1
        return f"{prefix}{self._last_number}"

    def variable(self, prefix: str, value: str) -> str:
        """Add a line that assigns a value to a new variable. Return the variable's name."""
        name = self.fresh(prefix)
        self.add(f"{name} = {value}")
        return name

    def constant(self, prefix: str, value: Any) -> str:
        """Return a new name for a value."""
        name = self.fresh(prefix)
        self.names[name] = value
        return name

    def function_for(self, verb: str, kind: FieldType) -> str:
        """Return the name of the function that reads or writes an inner message of a type."""
        name = f"{verb}_{kind.base.replace('/', '_')}"
        self.called[name] = get_interface(kind.base)
        return name


def compiled(text: str, name: str, names: dict[str, Any], title: str) -> Callable[..., Any]:
    """Return a function from its source.

    Args:
        text: The source.
        name: The function's name.
        names: Values of all names in the source that are not Python's own.
        title: Name of the source in tracebacks.
    """
    exec(compile(text, f"<{title}>", "exec"), names)  # noqa: S102 - our own text
    function: Callable[..., Any] = names[name]
    return function


def element(kind: FieldType) -> FieldType:
    """Return the type of an array's elements."""
    return kind._replace(kind="scalar", size=0)


def spec_named(name: str) -> MessageSpec:
    """Return the spec of the message type with this name."""
    return message_spec_of(get_interface(name))


def is_inline(spec: MessageSpec) -> bool:
    """Return whether a type's source contains the source of the messages inside it."""
    fields, loops = _fields_and_loops(spec, {})
    return fields <= _MAX_FIELDS and loops <= _MAX_LOOPS


def _fields_and_loops(spec: MessageSpec, known: dict[str, tuple[int, int]]) -> tuple[int, int]:
    """Return a message's number of fields at all levels, and the depth of its loops."""
    if spec.name not in known:
        fields, loops = 0, 0
        for kind in (field.type for field in spec.fields):
            inner = _fields_and_loops(spec_named(kind.base), known) if kind.is_message else (0, 0)
            fields += 1 + inner[0]
            loops = max(loops, inner[1] + (kind.kind != "scalar"))
        known[spec.name] = fields, loops
    return known[spec.name]
