"""Python source of a function, written line by line, with runs of values for `struct`.

A run is a group of neighbouring values whose distances are known. One `struct.Struct` packs or
unpacks all values of a run.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.interfaces import get_interface
from zbot.wire.cdr.alignment import Alignment, TypeLayout
from zbot.wire.function_source import FunctionSource

if TYPE_CHECKING:
    from zbot.interfaces.spec import FieldType


class Source(FunctionSource):
    """Lines of a function, and the current run, for which no line was added yet."""

    def __init__(self, known: Alignment) -> None:
        super().__init__()
        self.called: dict[str, type[Any]] = {}  #: classes of inner messages by function name
        self.layout = TypeLayout()
        self.known = known  #: alignment after the run
        self.format = ""
        self.run_size = 0

    def function_for(self, verb: str, kind: FieldType) -> str:
        """Return the name of the function that reads or writes an inner message of a type."""
        name = f"{verb}_{kind.base.replace('/', '_')}"
        self.called[name] = get_interface(kind.base)
        return name

    def pad_run(self, padding: int, code: str, size: int) -> None:
        """Put padding and a format code of `size` bytes at the end of the run."""
        self.format += "x" * padding + code
        self.run_size += padding + size
        self.known = self.known.after(padding + size)

    def take_run(self) -> tuple[str, int]:
        """Return the format and the size of the run, and begin a new run."""
        run = self.format, self.run_size
        self.format, self.run_size = "", 0
        return run


def element(kind: FieldType) -> FieldType:
    """Return the type of an array's elements."""
    return kind._replace(kind="scalar", size=0)
