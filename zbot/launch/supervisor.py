"""Supervisor that starts, restarts and stops one program, and emits events about the program."""

from __future__ import annotations

import asyncio
import shlex
import signal
import subprocess
import sys
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

from zbot.launch import process
from zbot.launch.actions.executable import check_program, not_started
from zbot.launch.errors import LaunchError, LaunchFileError, ProgramError
from zbot.launch.event import SecondInterrupt, Shutdown
from zbot.launch.event_handler import EventHandler
from zbot.launch.log_writer import OutputLines
from zbot.launch.process_event import (
    ProcessExited,
    ProcessIO,
    ProcessStarted,
    ProcessStderr,
    ProcessStdin,
    ProcessStdout,
    ShutdownProcess,
    SignalProcess,
)

if TYPE_CHECKING:
    from collections.abc import Mapping

    from zbot.launch.actions.executable import Prepared
    from zbot.launch.actions.execute import ExecuteLocal
    from zbot.launch.context import LaunchContext
    from zbot.launch.event import Event
    from zbot.launch.event_handler import BaseEventHandler

_OUTPUT_EVENTS: Final[Mapping[int, type[ProcessIO]]] = {1: ProcessStdout, 2: ProcessStderr}
_SIGKILL: Final = int(getattr(signal, "SIGKILL", signal.SIGTERM))


@dataclass(frozen=True)
class Policy:
    """Options that a supervisor uses to run a program."""

    shell: bool
    has_terminal: bool  #: whether stdout and stderr are pseudo terminals
    sinks: Mapping[str, frozenset[str]]  #: where `stdout`, `stderr` and `both` go
    line_format: str  #: a format that contains `{line}` and `{label}`
    sigterm_timeout_s: float  #: seconds from SIGINT to SIGTERM
    sigkill_timeout_s: float  #: seconds from SIGTERM to SIGKILL
    respawn: bool
    respawn_delay_s: float
    respawn_max_retries: int  #: unlimited if negative
    shows_command: bool


class Supervisor:
    """Runs the program of one action.

    Args:
        action: The action.
        context: The launch.
        prepared: The command line.
        policy: The options of the run.
    """

    def __init__(
        self, action: ExecuteLocal, context: LaunchContext, prepared: Prepared, policy: Policy
    ) -> None:
        self._action, self._context = action, context
        self._prepared, self._policy = prepared, policy
        self.label = context.next_label(prepared.name)
        self._process: process.ChildProcess | None = None
        self._stop_requested = asyncio.Event()
        self._escalate_now = asyncio.Event()
        self._sent: set[int] = set()
        self._escalation: asyncio.Task[None] | None = None
        self._task: asyncio.Task[None] | None = None
        self._is_restarting = False
        self._logs_first_signal = True

    def start(self) -> asyncio.Task[None]:
        """Run the program. The returned task is done when the last run of the program has ended."""
        handlers = self._handlers()
        for handler in handlers:  # not in the task, because the launch may end before it begins
            self._context.register_event_handler(handler)
        self._task = self._context.create_task(self._run(handlers))
        return self._task

    def restart(self) -> asyncio.Task[None]:
        """Stop the program and start it again. If it has ended, only start it.

        The end of a program that runs is not an event, so the launch does not react to it. Return
        the task of `start`.
        """
        self._context.writer.info(self.label, "the process is started again on request")
        if self._task is None or self._task.done():
            self._stop_requested.clear()
            self._escalation = None
            return self.start()
        is_running = self._process is not None and self._process.is_running
        if is_running and not self._is_stopping:
            self._is_restarting = True
            self._start_escalation()
        return self._task

    @property
    def _is_stopping(self) -> bool:
        return self._escalation is not None and not self._escalation.done()

    async def _run(self, handlers: list[BaseEventHandler]) -> None:
        try:
            await self._run_with_respawn()
        except (OSError, ProgramError) as error:
            self._report_not_started(error)
        finally:
            for handler in handlers:
                self._context.unregister_event_handler(handler)
            if self._escalation is not None:
                self._escalation.cancel()

    def _report_not_started(self, error: OSError | ProgramError) -> None:
        """Log why the program was not started. In a strict launch, this ends the launch."""
        reason = error if isinstance(error, ProgramError) else not_started(self._prepared, error)
        failure: LaunchError = reason
        if self._action.origin is not None:
            failure = LaunchFileError.at(self._action.origin, reason)
        if self._context.strict:
            self._context.fail(failure)
            return
        hint = f" ({reason.hint})" if reason.hint else ""
        self._context.writer.error(self.label, f"{failure}{hint}; the launch goes on without it")
        self._context.program_failed = True

    async def _run_with_respawn(self) -> None:
        retries = self._policy.respawn_max_retries
        while not self._stop_requested.is_set():
            code = await self._run_once()
            if self._ends_for_restart():
                continue
            if not self._policy.respawn or retries == 0 or self._stop_requested.is_set():
                self._context.program_failed |= code != 0 and not self._sent  # zbot sent no signal
                return
            retries -= 1
            await _wait(self._stop_requested, self._policy.respawn_delay_s)

    def _ends_for_restart(self) -> bool:
        """Return whether the run has ended only because the program is started again."""
        is_restarting, self._is_restarting = self._is_restarting, False
        if not is_restarting or self._stop_requested.is_set():
            return False
        if self._escalation is not None:
            self._escalation.cancel()
            self._escalation = None
        self._sent.clear()
        return True

    async def _run_once(self) -> int:
        prepared, writer = self._prepared, self._context.writer
        lines = OutputLines(self.label, self._policy.sinks, writer, self._policy.line_format)
        is_line = self._policy.shell
        early: list[tuple[int, bytes]] = []  # output that comes before ProcessStarted
        has_started = False

        def on_data(fd: int, data: bytes) -> None:
            if has_started:
                self._on_data(lines, fd, data)
            else:
                early.append((fd, data))

        if not is_line:
            check_program(prepared)
        child = await process.start(
            " ".join(prepared.words) if is_line else prepared.words,
            env=prepared.env,
            cwd=prepared.cwd,
            has_terminal=self._policy.has_terminal,
            stdin=self._stdin(),
            on_data=on_data,
            process_groups=self._context.process_groups,
        )
        self._process = child
        writer.info(self.label, f"process started with pid [{child.pid}]")
        if self._policy.shows_command:
            writer.info(self.label, f"process details: cmd='{shlex.join(prepared.words)}'")
        self._action.process_details = self.details()
        self._emit(ProcessStarted)
        has_started = True
        for fd, data in early:
            self._on_data(lines, fd, data)
        if self._stop_requested.is_set():  # the request came during the start
            self._start_escalation()
        code = await child.wait()
        lines.close()
        self._report_exit(code)
        return code

    def _stdin(self) -> int | None:
        # In a terminal, programs read the keyboard. Otherwise stdin is a pipe, for ProcessStdin.
        has_keys = not self._context.noninteractive and sys.stdin is not None and sys.stdin.isatty()
        return None if has_keys else subprocess.PIPE

    def details(self) -> dict[str, Any]:
        """Return the arguments of the process's events. Before the start, there is no `pid`."""
        prepared = self._prepared
        pid = {} if self._process is None else {"pid": self._process.pid}
        return {
            "action": self._action,
            "name": self.label,
            "cmd": prepared.words,
            "cwd": prepared.cwd,
            "env": prepared.env,
            **pid,
        }

    def _emit(self, kind: type[Any], **attributes: Any) -> None:
        self._context.emit_event_sync(kind(**self.details(), **attributes))

    def _on_data(self, lines: OutputLines, fd: int, data: bytes) -> None:
        lines.feed(fd, data)
        self._action.keep_output(fd, data)
        self._emit(_OUTPUT_EVENTS[fd], text=data)

    def _report_exit(self, code: int) -> None:
        pid = self._process.pid if self._process is not None else 0
        writer, words = self._context.writer, " ".join(self._prepared.words)
        if code == 0 or self._is_clean_exit(code):
            writer.info(self.label, f"process has finished cleanly [pid {pid}]")
        else:
            text = f"process has died [pid {pid}, exit code {code}, cmd '{words}']."
            writer.error(self.label, text)
        self._action.return_code = code
        if not self._is_restarting or self._stop_requested.is_set():
            self._emit(ProcessExited, returncode=code)

    def _is_clean_exit(self, code: int) -> bool:
        """Return whether the program had no error, or a signal of this supervisor ended it."""
        shells = {128 + number for number in self._sent}
        return code == 0 or -code in self._sent or code in shells

    # Event handlers

    def _handlers(self) -> list[BaseEventHandler]:
        def is_for_this(kind: type[Event]) -> Any:
            return lambda event: isinstance(event, kind) and event.process_matcher(self._action)  # type: ignore[attr-defined]

        def is_stdin(event: Event) -> bool:
            return isinstance(event, ProcessStdin) and event.action is self._action

        return [
            EventHandler(matcher=is_for_this(SignalProcess), entities=self._on_signal),
            EventHandler(matcher=is_for_this(ShutdownProcess), entities=self._on_stop),
            EventHandler(matcher=lambda e: isinstance(e, Shutdown), entities=self._on_stop),
            EventHandler(
                matcher=lambda e: isinstance(e, SecondInterrupt), entities=self._on_second_interrupt
            ),
            EventHandler(matcher=is_stdin, entities=self._on_stdin),
        ]

    def _on_stdin(self, event: ProcessStdin, _: LaunchContext) -> None:
        if self._process is not None:
            self._process.write(event.text)

    def _on_second_interrupt(self, *_: Any) -> None:
        self._escalate_now.set()

    def _on_signal(self, event: SignalProcess, _: LaunchContext) -> None:
        self._send(event.signal, is_logged=True)

    def _on_stop(self, event: Event, _: LaunchContext) -> None:
        if self._stop_requested.is_set():
            return
        self._stop_requested.set()
        self._logs_first_signal = not getattr(event, "due_to_sigint", False)
        if self._process is not None and not self._is_stopping:
            self._start_escalation()

    def _start_escalation(self) -> None:
        self._escalation = asyncio.get_running_loop().create_task(self._escalate())

    async def _escalate(self) -> None:
        """Send SIGINT, then SIGTERM, then SIGKILL, until the process has ended."""
        assert self._process is not None
        steps = (
            (signal.SIGINT, self._policy.sigterm_timeout_s, "SIGTERM"),
            (signal.SIGTERM, self._policy.sigkill_timeout_s, "SIGKILL"),
        )
        is_logged = self._logs_first_signal
        for number, seconds, following in steps:
            self._send(number, is_logged=is_logged)
            is_logged = True
            if await self._ended_within(seconds):
                return
            waited = f"'{seconds:g}' seconds after receiving"
            if self._escalate_now.is_set():
                self._escalate_now.clear()
                waited = "immediately after receiving"
            text = f"process[{self.label}] failed to terminate {waited} '{number.name}'"
            self._context.writer.error(self.label, f"{text}, escalating to '{following}'")
        self._send(_SIGKILL, is_logged=True)

    async def _ended_within(self, seconds: float) -> bool:
        assert self._process is not None
        ended = asyncio.ensure_future(self._process.ended())
        interrupted = asyncio.ensure_future(self._escalate_now.wait())
        await asyncio.wait(
            {ended, interrupted}, timeout=seconds, return_when=asyncio.FIRST_COMPLETED
        )
        for task in (ended, interrupted):
            task.cancel()
        return not self._process.is_running

    def _send(self, number: int, *, is_logged: bool) -> None:
        if self._process is None or not self._process.is_running:
            return
        if is_logged:
            name = signal.Signals(number).name
            self._context.writer.info(
                self.label, f"sending signal '{name}' to process[{self.label}]"
            )
        self._sent.add(number)
        self._process.send_signal(number)


async def _wait(event: asyncio.Event, seconds: float) -> None:
    task = asyncio.ensure_future(event.wait())
    await asyncio.wait({task}, timeout=seconds)
    task.cancel()
