"""Buffer that cuts the bytes of a port into lines."""

from __future__ import annotations

_LONGEST = 65_536  # bytes


class LineBuffer:
    """Bytes of a port that are not yet a whole line. A line ends with a line feed.

    Attributes:
        too_long: Number of lines that were discarded because they were too long.
    """

    def __init__(self) -> None:
        self._rest = b""
        self._is_skipping = False
        self.too_long = 0

    def __len__(self) -> int:
        return len(self._rest)

    def skip_line(self) -> None:
        """Discard all bytes up to the next line end."""
        self._is_skipping = True

    def feed(self, data: bytes) -> list[bytes]:
        """Return the lines that are whole now, without their line ends."""
        *lines, self._rest = (self._rest + data).split(b"\n")
        if self._is_skipping and lines:
            self._is_skipping = False
            lines = lines[1:]
        if self._is_skipping:
            self._rest = b""
        elif len(self._rest) > _LONGEST:
            self.too_long += 1
            self.skip_line()
            self._rest = b""
        return lines
