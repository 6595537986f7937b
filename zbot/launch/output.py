"""Where the lines of a process go: the screen, the common log, files of its own."""

from __future__ import annotations

import codecs
from typing import TYPE_CHECKING, Any, Final

from zbot.launch.errors import EntityTypeError

if TYPE_CHECKING:
    from collections.abc import Mapping

    from zbot.launch.journal import Journal

_STREAMS: Final = {1: "stdout", 2: "stderr"}
_OUT, _ERR = "stdout", "stderr"
#: What each word for `output` means. ROS 2 hides stdout by default; here everything is seen.
_WORDS: Final[Mapping[str, Mapping[str, frozenset[str]]]] = {
    "screen": {_OUT: frozenset({"screen"}), _ERR: frozenset({"screen"})},
    "log": {_OUT: frozenset({"log"}), _ERR: frozenset({"log", "screen"})},
    "both": {_OUT: frozenset({"log", "screen"}), _ERR: frozenset({"log", "screen"})},
    "own_log": {_OUT: frozenset({"own_log"}), _ERR: frozenset({"own_log"})},
    "full": {
        _OUT: frozenset({"log", "own_log", "screen"}),
        _ERR: frozenset({"log", "own_log", "screen"}),
    },
    "none": {_OUT: frozenset(), _ERR: frozenset()},
}
DEFAULT: Final = "both"


def parse_output(output: str | Mapping[str, Any]) -> dict[str, frozenset[str]]:
    """Return for stdout and stderr where it goes: `screen`, `log`, `own_log`.

    Raises:
        EntityTypeError: A word is unknown.
    """
    if isinstance(output, str):
        if output not in _WORDS:
            raise EntityTypeError("output", f"one of {', '.join(_WORDS)}", output)
        return dict(_WORDS[output])
    found: dict[str, frozenset[str]] = {}
    for stream in (_OUT, _ERR):
        words = output.get(stream, output.get("both", ()))
        words = [words] if isinstance(words, str) else words
        sinks = {sink for word in words for sink in parse_output(word)[stream]}
        found[stream] = frozenset(sinks)
    return found


class OutputLines:
    """Turns what a process writes into lines, and hands them on."""

    def __init__(
        self, label: str, sinks: Mapping[str, frozenset[str]], journal: Journal, form: str
    ) -> None:
        self._label, self._sinks, self._journal, self._form = label, sinks, journal, form
        decoder = codecs.getincrementaldecoder("utf-8")
        self._decoders = {fd: decoder("backslashreplace") for fd in _STREAMS}
        self._rest = dict.fromkeys(_STREAMS, "")

    def feed(self, fd: int, data: bytes) -> None:
        """Take what came; whole lines are written at once."""
        text = self._rest[fd] + self._decoders[fd].decode(data)
        *lines, self._rest[fd] = text.split("\n")
        for line in lines:
            self._write(fd, line.rstrip("\r"))

    def close(self) -> None:
        """Write what is left without a line's end."""
        for fd in _STREAMS:
            rest = self._rest[fd] + self._decoders[fd].decode(b"", final=True)
            self._rest[fd] = ""
            if rest:
                self._write(fd, rest)

    def _write(self, fd: int, line: str) -> None:
        stream = _STREAMS[fd]
        sinks = self._sinks[stream]
        formed = self._form.format(line=line, label=self._label)
        if "screen" in sinks:
            self._journal.output(self._label, formed)
        if "log" in sinks:
            self._journal.write("launch.log", formed)
        if "own_log" in sinks:
            self._journal.write(f"{self._label}-{stream}.log", line)
