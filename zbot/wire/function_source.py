"""Python source of one function, written line by line."""

from __future__ import annotations

from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterator


class FunctionSource:
    """Lines of a function, and the values of the names in them."""

    def __init__(self) -> None:
        self.names: dict[str, Any] = {}  #: values of the names in the source
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

    def constant(self, prefix: str, value: Any) -> str:
        """Return a new name for a value."""
        name = self.fresh(prefix)
        self.names[name] = value
        return name
