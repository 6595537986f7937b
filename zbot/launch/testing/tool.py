"""Functions for tests that start processes, or that wait for output or for the end of processes."""

from __future__ import annotations

import asyncio
import contextlib
import threading
from typing import TYPE_CHECKING, Any

from zbot.launch.description import LaunchDescription
from zbot.launch.event_handler import EventHandler
from zbot.launch.process_event import (
    ProcessExited,
    ProcessIO,
    ProcessStarted,
    ShutdownProcess,
    matches_action,
)
from zbot.launch.testing.error import LaunchTestError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from zbot.launch.actions.execute import ExecuteLocal
    from zbot.launch.context import LaunchContext
    from zbot.launch.service import LaunchService
    from zbot.launch.testing.record import ExitRecord, OutputRecord


class ProcessProxy:
    """A process under test.

    Args:
        process_action: The action of the process.
        proc_info: The record of the process's start and exit.
        proc_output: The record of the process's output.
        output_filter: Function that changes the output before the properties return it.
    """

    def __init__(
        self,
        process_action: ExecuteLocal,
        proc_info: ExitRecord,
        proc_output: OutputRecord,
        *,
        output_filter: Callable[[str], str] | None = None,
    ) -> None:
        self.target_process_action = process_action
        self._proc_info, self._proc_output = proc_info, proc_output
        self._filter = output_filter or str

    def wait_for_shutdown(self, timeout: float | None = None) -> bool:
        """Wait at most `timeout` seconds for the end of the process. Return whether it ended."""
        with self._proc_info.proc_event:
            return self._proc_info.proc_event.wait_for(lambda: self.terminated, timeout)

    def wait_for_output(
        self, condition: Callable[[str], Any] | None = None, timeout: float | None = None
    ) -> bool:
        """Wait until the output fulfils a condition. Without a condition, wait for any output."""
        is_so = condition or bool

        with self._proc_output.io_event:
            found = self._proc_output.io_event.wait_for(lambda: is_so(self.output), timeout)
        return bool(found)

    @property
    def stdout(self) -> str:
        """The output on stdout."""
        return self._filter(self._proc_output.text_of(self.target_process_action, "stdout"))

    @property
    def stderr(self) -> str:
        """The output on stderr."""
        return self._filter(self._proc_output.text_of(self.target_process_action, "stderr"))

    @property
    def output(self) -> str:
        """The output on stdout and stderr, in the order in which it came."""
        return self._filter(self._proc_output.text_of(self.target_process_action))

    @property
    def running(self) -> bool:
        """Whether the process was started and has not ended."""
        is_known = self.target_process_action in self._proc_info.processes()
        return is_known and not self.terminated

    @property
    def terminated(self) -> bool:
        """Whether the process has ended."""
        return self._proc_info.has_ended(self.target_process_action)

    @property
    def exit_code(self) -> int:
        """The exit code.

        Raises:
            LaunchTestError: The process has not ended.
        """
        if not self.terminated:
            raise LaunchTestError("the process has no exit code before it has ended")
        code: int = getattr(self._proc_info[self.target_process_action], "returncode", 0)
        return code


@contextlib.contextmanager
def launch_process(
    launch_service: LaunchService,
    process_action: ExecuteLocal,
    proc_info: ExitRecord,
    proc_output: OutputRecord,
    **options: Any,
) -> Iterator[ProcessProxy]:
    """Start a process in a running launch. The end of the `with` block ends the process.

    Args:
        launch_service: The launch.
        process_action: The process.
        proc_info: The record of the process's start and exit.
        proc_output: The record of the process's output.
        options: The options of `ProcessProxy`.
    """
    launch_service.include_launch_description(LaunchDescription([process_action]))
    proxy = ProcessProxy(process_action, proc_info, proc_output, **options)
    try:
        yield proxy
    finally:
        if not proxy.terminated:
            matcher = matches_action(process_action)
            launch_service.emit_event(ShutdownProcess(process_matcher=matcher))


# Functions for tests that use launch_pytest. Such tests have the context of the launch.


def _wait(
    context: LaunchContext,
    process: ExecuteLocal,
    is_so: Callable[[], Any],
    timeout: float | None,
) -> bool:
    changed = threading.Condition()

    def tell(event: object, _: object) -> None:
        del event
        with changed:
            changed.notify_all()

    kinds = (ProcessStarted, ProcessExited, ProcessIO)
    handler = EventHandler(
        matcher=lambda event: isinstance(event, kinds) and event.action is process, entities=tell
    )
    context.register_event_handler(handler)
    try:
        with changed:
            return bool(changed.wait_for(is_so, timeout))
    finally:
        context.unregister_event_handler(handler)


def _is_valid(validate: Callable[[str], Any], text: bytes) -> bool:
    try:
        answer = validate(text.decode(errors="replace"))
    except AssertionError:
        return False
    return answer is None or bool(answer)


def wait_for_output_sync(
    launch_context: LaunchContext,
    execute_process_action: ExecuteLocal,
    validate_output: Callable[[str], Any],
    timeout: float | None = None,
) -> bool:
    """Wait until a function accepts the stdout of a process.

    Args:
        launch_context: The value of the fixture `launch_context`.
        execute_process_action: The process, which needs `cached_output=True`.
        validate_output: Function that is called with the text. To reject the text, the function
            raises `AssertionError` or returns a false value other than `None`.
        timeout: Seconds to wait.

    Returns:
        Whether the function accepted the text in time.
    """
    process = execute_process_action
    return _wait(
        launch_context, process, lambda: _is_valid(validate_output, process.get_stdout()), timeout
    )


def wait_for_stderr_sync(
    launch_context: LaunchContext,
    execute_process_action: ExecuteLocal,
    validate_output: Callable[[str], Any],
    timeout: float | None = None,
) -> bool:
    """Wait until a function accepts the stderr of a process. See `wait_for_output_sync`."""
    process = execute_process_action
    return _wait(
        launch_context, process, lambda: _is_valid(validate_output, process.get_stderr()), timeout
    )


def wait_for_start_sync(
    launch_context: LaunchContext,
    execute_process_action: ExecuteLocal,
    timeout: float | None = None,
) -> bool:
    """Wait at most `timeout` seconds for the start of a process. Return whether it started."""
    process = execute_process_action
    return _wait(launch_context, process, lambda: "pid" in process.process_details, timeout)


def wait_for_exit_sync(
    launch_context: LaunchContext,
    execute_process_action: ExecuteLocal,
    timeout: float | None = None,
) -> bool:
    """Wait at most `timeout` seconds for the end of a process. Return whether it ended."""
    process = execute_process_action
    return _wait(launch_context, process, lambda: process.return_code is not None, timeout)


def assert_output_sync(
    launch_context: LaunchContext,
    execute_process_action: ExecuteLocal,
    validate_output: Callable[[str], Any],
    timeout: float | None = None,
) -> None:
    """Wait like `wait_for_output_sync`. Raise `AssertionError` if no text is accepted in time."""
    context, process = launch_context, execute_process_action
    if not wait_for_output_sync(context, process, validate_output, timeout):
        _refuse(validate_output, process.get_stdout())


def assert_stderr_sync(
    launch_context: LaunchContext,
    execute_process_action: ExecuteLocal,
    validate_output: Callable[[str], Any],
    timeout: float | None = None,
) -> None:
    """Wait like `wait_for_stderr_sync`. Raise `AssertionError` if no text is accepted in time."""
    context, process = launch_context, execute_process_action
    if not wait_for_stderr_sync(context, process, validate_output, timeout):
        _refuse(validate_output, process.get_stderr())


def _refuse(validate: Callable[[str], Any], text: bytes) -> None:
    output = text.decode(errors="replace")
    validate(output)
    raise AssertionError(f"the output was rejected: {output!r}")


def _awaitable(function: Callable[..., Any]) -> Callable[..., Any]:
    async def waiting(*args: Any, **kwargs: Any) -> Any:
        return await asyncio.to_thread(function, *args, **kwargs)

    waiting.__doc__ = f"{function.__doc__}"
    return waiting


wait_for_output = _awaitable(wait_for_output_sync)
wait_for_stderr = _awaitable(wait_for_stderr_sync)
wait_for_start = _awaitable(wait_for_start_sync)
wait_for_exit = _awaitable(wait_for_exit_sync)
assert_output = _awaitable(assert_output_sync)
assert_stderr = _awaitable(assert_stderr_sync)
