"""Sinks of a program's output: the screen, the launch's log file, the program's own log files."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from zbot.launch.errors import output_error

if TYPE_CHECKING:
    from collections.abc import Mapping

_OUT, _ERR, _BOTH = "stdout", "stderr", "both"
_SINKS: Final = frozenset({"screen", "log", "own_log"})
_OWN: Final = frozenset({"own_log"})
#: Sinks for each value of `output`. By default ROS 2 hides stdout, but zbot shows everything.
_WORDS: Final[Mapping[str, Mapping[str, frozenset[str]]]] = {
    "screen": {_BOTH: frozenset({"screen"})},
    "log": {_BOTH: frozenset({"log"}), _ERR: frozenset({"screen"})},
    "both": {_BOTH: frozenset({"log", "screen"})},
    "own_log": {_OUT: _OWN, _ERR: _OWN, _BOTH: _OWN},
    "full": {_OUT: _OWN, _ERR: _OWN, _BOTH: _SINKS},
    "none": {},
}
DEFAULT: Final = "both"


def parse_output(output: str | Mapping[str, Any]) -> dict[str, frozenset[str]]:
    """Return the sinks (`screen`, `log`, `own_log`) for `stdout`, `stderr` and `both`.

    Raises:
        LaunchUsageError: A word is unknown.
    """
    found: dict[str, frozenset[str]] = dict.fromkeys((_OUT, _ERR, _BOTH), frozenset())
    if isinstance(output, str):
        if output not in _WORDS:
            raise output_error(output, _WORDS)
        return {**found, **_WORDS[output]}
    for stream, words in output.items():
        if stream not in found:
            raise output_error(stream, found)
        sinks = {words} if isinstance(words, str) else set(words)
        if unknown := sorted(map(str, sinks - _SINKS)):
            raise output_error(unknown[0], sorted(_SINKS))
        found[stream] = frozenset(sinks)
    return found
