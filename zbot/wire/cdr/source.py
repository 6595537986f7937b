"""Python source of a function, written line by line, with groups of values for `struct`.

In these modules, a *struct* is a group of neighbouring values whose distances are known. One
`struct.Struct` packs or unpacks all values of a struct.
"""

from __future__ import annotations

from zbot.wire.cdr.alignment import Alignment, TypeLayout
from zbot.wire.function_source import FunctionSource


class Source(FunctionSource):
    """Lines of a function, and the current struct, for which no line was added yet."""

    def __init__(self, known: Alignment) -> None:
        super().__init__()
        self.layout = TypeLayout()
        self.known = known  #: alignment after the struct
        self.format = ""
        self.struct_size = 0

    def pad_struct(self, padding: int, code: str, size: int) -> None:
        """Put padding and a format code of `size` bytes at the end of the struct."""
        self.format += "x" * padding + code
        self.struct_size += padding + size
        self.known = self.known.after(padding + size)

    def take_struct(self) -> tuple[str, int]:
        """Return the format and the size of the struct, and begin a new struct."""
        taken = self.format, self.struct_size
        self.format, self.struct_size = "", 0
        return taken
