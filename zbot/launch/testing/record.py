"""Records of the output and the exit of processes, which tests in another thread read."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

from zbot.launch.process_event import ProcessExited, ProcessIO, RunningProcessEvent
from zbot.launch.testing.error import NoMatchingProcessError
from zbot.launch.testing.output_text import has_expected, without_escapes
from zbot.launch.testing.process_lookup import name_of, resolve_processes

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from zbot.launch.actions.execute import ExecuteLocal

_TIMEOUT_S = 10.0  # the default of launch_testing


class OutputRecord:
    """List of output events. Each event has `text`, `from_stdout`, `process_name` and `action`."""

    def __init__(self) -> None:
        self.io_event = threading.Condition()
        self._events: list[ProcessIO] = []
        self._processes: dict[ExecuteLocal, str] = {}

    def append(self, process_io: ProcessIO) -> None:
        """Add an output event."""
        self.track(process_io)
        with self.io_event:
            self._events.append(process_io)
            self.io_event.notify_all()

    def track(self, started: object) -> None:
        """Add the process of an event. Then the process is known even if it has no output yet.

        Objects that are not events of a process are ignored.
        """
        if isinstance(started, RunningProcessEvent):
            with self.io_event:
                self._processes[started.action] = started.process_name

    def __iter__(self) -> Iterator[ProcessIO]:
        with self.io_event:
            return iter(list(self._events))

    def __getitem__(self, key: ExecuteLocal | str) -> list[ProcessIO]:
        """Return the output events of a process. The key is its action or its full label."""
        return [piece for piece in self if key in (piece.process_name, piece.action)]

    def processes(self) -> list[ExecuteLocal]:
        """Return the actions of the processes that were started."""
        with self.io_event:
            return list(self._processes)

    def process_names(self) -> list[str]:
        """Return the labels of the processes that were started."""
        with self.io_event:
            return list(self._processes.values())

    def text_of(self, process: ExecuteLocal, stream: str = "both") -> str:
        """Return the output of a process on `stdout`, `stderr` or `both`."""
        wanted = {"stdout": (1,), "stderr": (2,)}.get(stream, (1, 2))
        pieces = b"".join(piece.text for piece in self[process] if piece.fd in wanted)
        return pieces.decode(errors="replace")

    def has(
        self,
        expected_output: Any,
        process: ExecuteLocal | str | None = None,
        cmd_args: Any = None,
        *,
        stream: str = "both",
        output_filter: Callable[[str], str] | None = None,
        strict_proc_matching: bool = True,
        strip_ansi_escape_sequences: bool = True,
    ) -> bool:
        """Return whether a matching process has the expected output. See `has_expected`.

        Raises:
            NoMatchingProcessError: No started process matches.
            SeveralProcessesError: Several processes match the name.
        """
        found = resolve_processes(
            self, process=process, cmd_args=cmd_args, strict_proc_matching=strict_proc_matching
        )
        for action in found:
            text = self.text_of(action, stream)
            text = without_escapes(text) if strip_ansi_escape_sequences else text
            if has_expected(expected_output, output_filter(text) if output_filter else text):
                return True
        return False

    def waitFor(  # noqa: N802 - launch_testing's name
        self,
        expected_output: Any,
        process: ExecuteLocal | str | None = None,
        cmd_args: Any = None,
        *,
        timeout: float | None = _TIMEOUT_S,
        stream: str = "both",
        **options: Any,
    ) -> bool:
        """Wait at most `timeout` seconds for expected output. Return whether the output came.

        Raises:
            NoMatchingProcessError: No matching process was started in time.
        """
        unknown: list[NoMatchingProcessError] = []

        def is_there() -> bool:
            try:
                found = self.has(expected_output, process, cmd_args, stream=stream, **options)
            except NoMatchingProcessError as error:
                unknown[:] = [error]
                return False
            unknown.clear()
            return found

        with self.io_event:
            found = self.io_event.wait_for(is_there, timeout)
        if not found and unknown:
            raise unknown[0]
        return found

    def assertWaitFor(  # noqa: N802 - launch_testing's name
        self, expected_output: Any = None, *args: Any, msg: Any = None, **options: Any
    ) -> None:
        """Wait for expected output. The arguments are the same as for `waitFor`.

        Raises:
            AssertionError: The output did not come in time.
        """
        expected = expected_output if expected_output is not None else msg
        if not self.waitFor(expected, *args, **options):
            raise AssertionError(f"the output {expected!r} did not come in time")


class ExitRecord:
    """The last event of each process: its start, or its exit with the `returncode`."""

    def __init__(self) -> None:
        self.proc_event = threading.Condition()
        self._events: dict[ExecuteLocal, RunningProcessEvent] = {}

    def append(self, process_info: RunningProcessEvent) -> None:
        """Add the start or the exit of a process."""
        with self.proc_event:
            self._events[process_info.action] = process_info
            self.proc_event.notify_all()

    def __iter__(self) -> Iterator[RunningProcessEvent]:
        with self.proc_event:
            return iter(list(self._events.values()))

    def __getitem__(self, key: ExecuteLocal | str) -> RunningProcessEvent:
        """Return the last event of a process. The key is its action or a part of its label."""
        with self.proc_event:
            for process, event in self._events.items():
                if process is key or (isinstance(key, str) and key in name_of(process)):
                    return event
        raise KeyError(key)

    def processes(self) -> list[ExecuteLocal]:
        """Return the actions of the processes that were started."""
        with self.proc_event:
            return list(self._events)

    def process_names(self) -> list[str]:
        """Return the labels of the processes that were started."""
        return list(map(name_of, self.processes()))

    def has_ended(self, process: ExecuteLocal) -> bool:
        """Return whether a process was started and has ended."""
        return isinstance(self._events.get(process), ProcessExited)

    def assertWaitForShutdown(  # noqa: N802 - launch_testing's name
        self,
        process: ExecuteLocal | str,
        cmd_args: Any = None,
        *,
        timeout: float | None = _TIMEOUT_S,
    ) -> None:
        """Wait until a process has ended.

        Raises:
            AssertionError: The process did not end in time.
        """
        self._wait(process, cmd_args, timeout, self.has_ended, "end")

    def assertWaitForStartup(  # noqa: N802 - launch_testing's name
        self,
        process: ExecuteLocal | str,
        cmd_args: Any = None,
        *,
        timeout: float | None = _TIMEOUT_S,
    ) -> None:
        """Wait until a process was started.

        Raises:
            AssertionError: The process was not started in time.
        """
        self._wait(process, cmd_args, timeout, lambda _: True, "start")

    def _wait(
        self,
        process: ExecuteLocal | str,
        cmd_args: Any,
        timeout: float | None,
        is_so: Callable[[ExecuteLocal], bool],
        what: str,
    ) -> None:
        def is_it() -> bool:
            try:
                return is_so(resolve_processes(self, process=process, cmd_args=cmd_args)[0])
            except NoMatchingProcessError:
                return False

        with self.proc_event:
            if not self.proc_event.wait_for(is_it, timeout):
                name = process if isinstance(process, str) else name_of(process)
                raise AssertionError(f"Timed out waiting for process {name!r} to {what}")
