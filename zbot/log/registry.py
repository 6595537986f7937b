"""Where all log lines of the process meet: levels, sinks, and the way to each output."""

from __future__ import annotations

import threading
import time
import weakref
from collections.abc import Callable
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, TypeAlias

from zbot.errors import ExternalShutdownException
from zbot.log.console import Console
from zbot.log.log_file import LogFile
from zbot.log.record import Record
from zbot.log.severity import LoggingSeverity, to_severity

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from types import FrameType

Sink: TypeAlias = Callable[[Record], object]

_DEFAULT_LEVEL: Final = LoggingSeverity.INFO
_OWN_NAME: Final = "zbot"


@dataclass(eq=False)
class Tap:
    """A sink and the logger whose lines it gets."""

    name: str
    sink: Sink
    has_failed: bool = False


@dataclass(eq=False)
class Channel:
    """What the loggers of one name share; read without a lock."""

    name: str
    threshold: LoggingSeverity  #: the least severity that is written
    taps: tuple[Tap, ...]  #: of the name and its parents


@dataclass(eq=False)
class _Outputs:
    """Made for the first line, from the environment of that moment."""

    console: Console
    file: LogFile


class _Thread(threading.local):
    is_feeding = False  #: whether a sink is at work in this thread


class Hub:
    """The log of the process. All methods may be called from any thread."""

    def __init__(self) -> None:
        # Re-entrant, for a signal's handler may log while its thread is in here.
        self._lock = threading.RLock()
        self._levels: dict[str, LoggingSeverity] = {}
        self._taps: list[Tap] = []
        self._channels: weakref.WeakValueDictionary[str, Channel] = weakref.WeakValueDictionary()
        self._thread = _Thread()
        self._is_console_on = self._is_sinking = self._is_file_on = True
        self._file_prefix = ""
        self._outputs: _Outputs | None = None

    # -- settings ------------------------------------------------------------------------------

    def configure(
        self,
        levels: Mapping[str, int] | int | None = None,
        *,
        stdout_enabled: bool = True,
        rosout_enabled: bool = True,
        file_enabled: bool = True,
        file_prefix: str = "",
    ) -> None:
        """Set what a command line's `--ros-args` can set.

        Args:
            levels: Levels by logger name, where an empty name is every logger without one of its
                own; or that level alone. Names that are not given keep their levels.
            stdout_enabled: Whether lines go to the console, be it stdout or stderr.
            rosout_enabled: Whether lines go to sinks.
            file_enabled: Whether lines go to a file, if a folder for logs is set.
            file_prefix: What the file's name begins with; the program's name if empty.

        Raises:
            InvalidSeverityError: A level is none.
        """
        given = {"": levels} if isinstance(levels, int) else levels or {}
        checked = {name: to_severity(level) for name, level in given.items()}
        with self._lock:
            self._levels.update(checked)
            self._is_console_on, self._is_sinking = stdout_enabled, rosout_enabled
            self._is_file_on = file_enabled
            if file_prefix != self._file_prefix:
                self._file_prefix = file_prefix
                self._close_outputs()
            self._refresh()

    def clear_config(self) -> None:
        """Forget all levels and settings, and read the environment anew. Sinks stay."""
        with self._lock:
            self._levels.clear()
            self._is_console_on = self._is_sinking = self._is_file_on = True
            self._file_prefix = ""
            self._close_outputs()
            self._refresh()

    def _close_outputs(self) -> None:
        outputs, self._outputs = self._outputs, None
        if outputs is not None:
            outputs.file.close()

    # -- levels --------------------------------------------------------------------------------

    def set_logger_level(self, name: str, level: int, detailed_error: bool = False) -> None:  # noqa: ARG002, FBT - rclpy's signature
        """Set the least severity that a logger and its children write.

        Args:
            name: The logger; an empty name sets the level of all that have none of their own.
            level: A `LoggingSeverity`; `UNSET` leaves it to the parent; with an empty name,
                everything is written.
            detailed_error: Without effect: errors always say what is wrong.

        Raises:
            InvalidSeverityError: There is no such level.
        """
        severity = to_severity(level)
        with self._lock:
            self._levels[name] = severity
            self._refresh()

    def get_logger_level(self, name: str) -> LoggingSeverity:
        """Return a logger's own level; `UNSET` if it has none."""
        unset = LoggingSeverity.UNSET if name else _DEFAULT_LEVEL
        return self._levels.get(name, unset)

    def get_logger_effective_level(self, name: str) -> LoggingSeverity:
        """Return the least severity that a logger writes: its own level or its nearest parent's."""
        while name:
            if level := self._levels.get(name):
                return level
            name = name.rpartition(".")[0]
        return self._levels.get("", _DEFAULT_LEVEL)

    # -- sinks ---------------------------------------------------------------------------------

    def add_sink(self, logger_name: str, sink: Sink) -> None:
        """Pass every line that a logger and its children write to a function as well.

        It is called in the thread that logs, must be quick, and what it logs itself goes to the
        console only. When it raises, that is reported on the console, once.

        Args:
            logger_name: The logger; an empty name is all of them.
            sink: Called with a `Record`.
        """
        with self._lock:
            self._taps.append(Tap(logger_name, sink))
            self._refresh()

    def remove_sink(self, logger_name: str, sink: Sink) -> None:
        """Undo one `add_sink`; nothing happens if there was none."""
        with self._lock:
            for tap in self._taps:
                if tap.name == logger_name and tap.sink == sink:
                    self._taps.remove(tap)
                    break
            self._refresh()

    @contextmanager
    def away_from_sinks(self) -> Iterator[None]:
        """Keep this thread's lines from the sinks: for lines about what the sinks caused."""
        was, self._thread.is_feeding = self._thread.is_feeding, True
        try:
            yield
        finally:
            self._thread.is_feeding = was

    # -- lines ---------------------------------------------------------------------------------

    def channel(self, name: str) -> Channel:
        """Return what the loggers of a name share."""
        with self._lock:
            channel = self._channels.get(name)
            if channel is None:
                level = self.get_logger_effective_level(name)
                channel = self._channels[name] = Channel(name, level, self._taps_of(name))
            return channel

    def emit(
        self, channel: Channel, severity: LoggingSeverity, message: object, frame: FrameType
    ) -> None:
        """Write one line to all outputs, whatever the channel's threshold is."""
        code = frame.f_code
        record = Record(
            time.time_ns(),
            severity,
            channel.name,
            _text(message),
            code.co_filename,
            code.co_name,
            frame.f_lineno,
        )
        outputs = self._outputs or self._open_outputs()
        line = outputs.console.format(record)
        if self._is_console_on:
            outputs.console.write(severity, line)
        if self._is_file_on and outputs.file.is_open:
            self._write_file(outputs.file, line)
        if channel.taps and self._is_sinking and not self._thread.is_feeding:
            self._feed(channel.taps, record)

    def _open_outputs(self) -> _Outputs:
        with self._lock:
            if self._outputs is None:
                self._outputs = _Outputs(Console(), LogFile(self._file_prefix))
                for complaint in self._outputs.console.complaints:
                    self._complain(complaint)
            return self._outputs

    def _write_file(self, file: LogFile, line: str) -> None:
        try:
            file.write(line)
        except OSError as error:
            self._complain(f"cannot write the log file, which ends here: {error}")

    def _feed(self, taps: tuple[Tap, ...], record: Record) -> None:
        self._thread.is_feeding = True
        try:
            for tap in taps:
                self._feed_one(tap, record)
        finally:
            self._thread.is_feeding = False

    def _feed_one(self, tap: Tap, record: Record) -> None:
        try:
            tap.sink(record)
        except ExternalShutdownException:
            raise  # a signal came meanwhile: that is not the sink's fault
        except Exception as error:  # noqa: BLE001 - a sink may be anybody's function
            if not tap.has_failed:
                tap.has_failed = True
                self._complain(f"a sink of logger {tap.name!r} failed, told once: {error!r}")

    def _complain(self, text: str) -> None:
        """Write a line about the log itself; to the console only, for that is the last resort."""
        console, level = (self._outputs or self._open_outputs()).console, LoggingSeverity.WARN
        record = Record(time.time_ns(), level, _OWN_NAME, _text(text), __file__, "_complain", 0)
        console.write(level, console.format(record))

    def _refresh(self) -> None:
        # Not `values()`, which runs Python in between: loggers of other threads end meanwhile.
        for reference in self._channels.valuerefs():
            channel = reference()
            if channel is not None:
                channel.threshold = self.get_logger_effective_level(channel.name)
                channel.taps = self._taps_of(channel.name)

    def _taps_of(self, name: str) -> tuple[Tap, ...]:
        return tuple(
            tap
            for tap in self._taps
            if not tap.name or name == tap.name or name.startswith(f"{tap.name}.")
        )


def _text(message: object) -> str:
    """Return text that every output can carry: lone surrogates are no UTF-8."""
    text = message if isinstance(message, str) else str(message)
    if not text.isascii():
        try:
            text.encode()
        except UnicodeEncodeError:
            return text.encode(errors="backslashreplace").decode()
    return text


#: The process's log.
HUB: Final = Hub()
