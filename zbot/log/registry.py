"""Registry of the log levels and sinks of a process. It writes all log lines to the outputs."""

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
from zbot.log.record import LoggingSeverity, Record, to_severity

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from types import FrameType

Sink: TypeAlias = Callable[[Record], object]

_DEFAULT_LEVEL: Final = LoggingSeverity.INFO
_OWN_NAME: Final = "zbot"


@dataclass(eq=False)
class SinkEntry:
    """A sink and the name of the logger whose lines it gets."""

    name: str
    sink: Sink
    has_failed: bool = False


@dataclass(eq=False)
class LoggerState:
    """State that all loggers with the same name share. It is read without a lock."""

    name: str
    threshold: LoggingSeverity  #: the lowest severity that is written
    sinks: tuple[SinkEntry, ...]  #: sinks of this logger and of its parents


@dataclass(eq=False)
class _Outputs:
    """Console and log file. The first log line makes both, and they read the environment then."""

    console: Console
    file: LogFile


class _ThreadState(threading.local):
    are_sinks_disabled = False  #: whether the sinks do not get this thread's lines


class LogRegistry:
    """Levels, sinks and outputs of the process's loggers. All methods are thread-safe."""

    def __init__(self) -> None:
        # Re-entrant, because a signal handler may log while its thread holds the lock.
        self._lock = threading.RLock()
        self._levels: dict[str, LoggingSeverity] = {}
        self._sinks: list[SinkEntry] = []
        self._states: weakref.WeakValueDictionary[str, LoggerState] = weakref.WeakValueDictionary()
        self._thread = _ThreadState()
        self._is_console_on = self._are_sinks_on = self._is_file_on = True
        self._file_prefix = ""
        self._outputs: _Outputs | None = None

    def renew_locks(self) -> None:
        """In a forked child, replace the locks, which threads of the parent may hold.

        The child writes into the same log file as its parent.
        """
        self._lock = threading.RLock()
        if self._outputs is not None:
            self._outputs.file.renew_lock()

    def configure(
        self,
        levels: Mapping[str, int] | int | None = None,
        *,
        stdout_enabled: bool = True,
        rosout_enabled: bool = True,
        file_enabled: bool = True,
        file_prefix: str = "",
    ) -> None:
        """Apply the log settings of a command line's `--ros-args`.

        Args:
            levels: Levels by logger name. The level of the empty name is the default
                for loggers without a level. A single level sets only this default.
            stdout_enabled: Whether lines go to the console (stdout or stderr).
            rosout_enabled: Whether lines go to sinks.
            file_enabled: Whether lines go to a file, if a log folder is set.
            file_prefix: Replaces the program's name in the file's name, if it is not empty.

        Raises:
            InvalidSeverityError: A level does not exist.
        """
        given = {"": levels} if isinstance(levels, int) else levels or {}
        checked = {name: to_severity(level) for name, level in given.items()}
        with self._lock:
            self._levels.update(checked)
            self._is_console_on, self._are_sinks_on = stdout_enabled, rosout_enabled
            self._is_file_on = file_enabled
            if file_prefix != self._file_prefix:
                self._file_prefix = file_prefix
                self._close_outputs()
            self._refresh()

    def clear_config(self) -> None:
        """Reset all levels and settings, and read the environment again. Sinks are kept."""
        with self._lock:
            self._levels.clear()
            self._is_console_on = self._are_sinks_on = self._is_file_on = True
            self._file_prefix = ""
            self._close_outputs()
            self._refresh()

    def _close_outputs(self) -> None:
        outputs, self._outputs = self._outputs, None
        if outputs is not None:
            outputs.file.close()

    def set_logger_level(self, name: str, level: int, detailed_error: bool = False) -> None:  # noqa: ARG002, FBT - rclpy's signature
        """Set the lowest severity that a logger and its children write.

        Args:
            name: The logger. An empty name sets the default for loggers without a level.
            level: A `LoggingSeverity`. With `UNSET`, a logger has its parent's level. If the
                default is `UNSET`, everything is written.
            detailed_error: It has no effect, because errors always have a detailed message.

        Raises:
            InvalidSeverityError: There is no such level.
        """
        severity = to_severity(level)
        with self._lock:
            self._levels[name] = severity
            self._refresh(name)

    def get_logger_level(self, name: str) -> LoggingSeverity:
        """Return a logger's own level. Return `UNSET` if the logger has no own level."""
        unset = LoggingSeverity.UNSET if name else _DEFAULT_LEVEL
        return self._levels.get(name, unset)

    def get_logger_effective_level(self, name: str) -> LoggingSeverity:
        """Return the lowest severity that a logger writes: its level or the nearest parent's."""
        while name:
            if level := self._levels.get(name):
                return level
            name = name.rpartition(".")[0]
        return self._levels.get("", _DEFAULT_LEVEL)

    def add_sink(self, logger_name: str, sink: Sink) -> None:
        """Add a function that gets every line of a logger and its children.

        The function runs in the thread that logs, so it must be fast. The function's own log lines
        go only to the console and the file. If the function raises errors, the console reports only
        the first error.

        Args:
            logger_name: The logger. An empty name means all loggers.
            sink: The function. Its argument is a `Record`.
        """
        with self._lock:
            self._sinks.append(SinkEntry(logger_name, sink))
            self._refresh(logger_name)

    def remove_sink(self, logger_name: str, sink: Sink) -> None:
        """Undo one `add_sink`. The call has no effect if the sink was not added."""
        with self._lock:
            for entry in self._sinks:
                if entry.name == logger_name and entry.sink == sink:
                    self._sinks.remove(entry)
                    break
            self._refresh(logger_name)

    @contextmanager
    def sinks_disabled(self) -> Iterator[None]:
        """Return a context manager. In its block, the sinks do not get this thread's lines."""
        was, self._thread.are_sinks_disabled = self._thread.are_sinks_disabled, True
        try:
            yield
        finally:
            self._thread.are_sinks_disabled = was

    def state_of(self, name: str) -> LoggerState:
        """Return the state that all loggers of a name share."""
        with self._lock:
            state = self._states.get(name)
            if state is None:
                level = self.get_logger_effective_level(name)
                state = self._states[name] = LoggerState(name, level, self._sinks_of(name))
            return state

    def emit(
        self, state: LoggerState, severity: LoggingSeverity, message: object, frame: FrameType
    ) -> None:
        """Write one line to all outputs. Do not compare its severity with the threshold."""
        code = frame.f_code
        record = Record(
            time.time_ns(),
            severity,
            state.name,
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
        if state.sinks and self._are_sinks_on and not self._thread.are_sinks_disabled:
            self._call_sinks(state.sinks, record)

    def _open_outputs(self) -> _Outputs:
        with self._lock:
            if self._outputs is None:
                self._outputs = _Outputs(Console(), LogFile(self._file_prefix))
                for error in self._outputs.console.setting_errors:
                    self._warn(error)
            return self._outputs

    def _write_file(self, file: LogFile, line: str) -> None:
        try:
            file.write(line)
        except OSError as error:
            self._warn(f"cannot write the log file, so it gets no more lines: {error}")

    def _call_sinks(self, sinks: tuple[SinkEntry, ...], record: Record) -> None:
        self._thread.are_sinks_disabled = True
        try:
            for entry in sinks:
                self._call_sink(entry, record)
        finally:
            self._thread.are_sinks_disabled = False

    def _call_sink(self, entry: SinkEntry, record: Record) -> None:
        try:
            entry.sink(record)
        except ExternalShutdownException:
            raise  # a signal during the call is not an error of the sink
        except Exception as error:  # noqa: BLE001 - a sink may raise any exception
            if not entry.has_failed:
                entry.has_failed = True
                self._warn(
                    f"a sink of logger {entry.name!r} failed (more errors are hidden): {error!r}"
                )

    def _warn(self, text: str) -> None:
        """Write a warning about logging itself, only to the console."""
        console, level = (self._outputs or self._open_outputs()).console, LoggingSeverity.WARN
        record = Record(time.time_ns(), level, _OWN_NAME, _text(text), __file__, "_warn", 0)
        console.write(level, console.format(record))

    def _refresh(self, name: str = "") -> None:
        """Renew the states of a logger and its children. An empty name means all loggers."""
        # `values()` would fail if another thread deletes a logger during the iteration.
        for reference in self._states.valuerefs():
            state = reference()
            if state is not None and _is_within(state.name, name):
                state.threshold = self.get_logger_effective_level(state.name)
                state.sinks = self._sinks_of(state.name)

    def _sinks_of(self, name: str) -> tuple[SinkEntry, ...]:
        return tuple(entry for entry in self._sinks if _is_within(name, entry.name))


def _is_within(name: str, parent: str) -> bool:
    """Return whether a logger is `parent` or one of its children. All are of the empty name."""
    return not parent or name == parent or name.startswith(f"{parent}.")


def _text(message: object) -> str:
    """Return the message as text. Characters that UTF-8 cannot encode are escaped."""
    text = message if isinstance(message, str) else str(message)
    if not text.isascii():
        try:
            text.encode()
        except UnicodeEncodeError:
            return text.encode(errors="backslashreplace").decode()
    return text


#: The registry of this process.
REGISTRY: Final = LogRegistry()
