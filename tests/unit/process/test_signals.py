"""Tests of the signal handlers in the process of the tests, which is left as it was."""

from __future__ import annotations

import signal
import sys
import threading
from typing import TYPE_CHECKING, Any

import pytest

from zbot.errors import ExternalShutdownException, NotInitializedError
from zbot.process import signals
from zbot.process.signals import Interrupted, MainThread, SignalExit, SignalHandlerOptions
from zbot.threads.foreign_call import without_interruption
from zbot.threads.weak_set import WeakSet

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")

INT, TERM = signal.SIGINT, signal.SIGTERM


class Context:
    def __init__(self) -> None:
        self.interruptions = 0

    def interrupt(self) -> None:
        self.interruptions += 1


@pytest.fixture(autouse=True)
def context(monkeypatch: pytest.MonkeyPatch) -> Iterator[Context]:
    """Return the only context of the process, whose state is restored after the test."""
    for name in ("received", "count", "is_terminated", "must_look", "ends_by", "installed_by"):
        monkeypatch.setattr(signals._Process, name, getattr(signals._Process, name))
    monkeypatch.setattr(signals._Process, "previous", {})
    monkeypatch.setattr(signals, "contexts", WeakSet[Any]())
    monkeypatch.setattr(signals, "guard_conditions", WeakSet[Any]())
    monkeypatch.setattr(MainThread, "spinning", set())
    monkeypatch.setattr(sys, "excepthook", sys.excepthook)
    handlers = {number: signal.getsignal(number) for number in (INT, TERM)}
    made = Context()
    signals.add_context(made)
    signal.signal(INT, signal.default_int_handler)
    signal.signal(TERM, signal.SIG_DFL)
    yield made
    for number, handler in handlers.items():
        signal.signal(number, handler)


def raised(number: int) -> type[BaseException] | None:
    """Return the type of the exception that a signal raises, if any."""
    try:
        signal.raise_signal(number)
    except BaseException as error:  # noqa: BLE001 - also of the end of the process
        return type(error)
    return None


def in_thread(work: Callable[[], object]) -> None:
    thread = threading.Thread(target=work)
    thread.start()
    thread.join(10)


# -- handlers --------------------------------------------------------------------------------------


@pytest.mark.parametrize("options", SignalHandlerOptions)
def test_the_chosen_signals_are_handled_until_they_are_uninstalled(
    options: SignalHandlerOptions,
) -> None:
    signals.install(options)
    assert signals.installed() is options
    assert signals.ends_program(INT) == bool(options.value & 1)
    assert signals.ends_program(TERM) == bool(options.value & 2)
    signals.uninstall()
    assert signals.installed() is SignalHandlerOptions.NO
    assert signal.getsignal(INT) is signal.default_int_handler
    assert signal.getsignal(TERM) is signal.SIG_DFL


def test_handlers_are_installed_in_the_main_thread_only() -> None:
    in_thread(signals.install)
    assert signals.installed() is SignalHandlerOptions.NO
    signals.install()
    in_thread(signals.uninstall)
    assert signals.installed() is SignalHandlerOptions.ALL


def test_a_signal_interrupts_all_contexts(context: Context) -> None:
    other = Context()
    signals.add_context(other)
    signals.install()
    raised(INT)
    assert (context.interruptions, other.interruptions) == (1, 1)
    assert signals.last_signal() == INT
    assert signals.was_received()


def test_a_context_that_is_initialised_while_sigterm_comes_is_interrupted(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(signals, "_LOOK_TIMEOUT_S", 60.0)
    signals.install()
    assert raised(TERM) is None  # the program may still look at `ok()`
    late = Context()
    signals.add_context(late)
    assert late.interruptions == 1
    signals.note_look()
    next_one = Context()
    signals.add_context(next_one)
    assert next_one.interruptions == 0


@pytest.mark.parametrize("number", [INT, TERM])
def test_a_handler_of_the_program_is_called_and_raises_nothing(
    context: Context, number: int
) -> None:
    called = list[int]()
    signal.signal(number, lambda got, _: called.append(got))
    signals.install()
    assert raised(number) is None
    assert (called, context.interruptions) == ([number], 1)


def test_a_signal_wakes_the_guard_conditions() -> None:
    class Guard:
        triggered = threading.Event()

        def trigger(self) -> None:
            self.triggered.set()

    guard = Guard()
    signals.guard_conditions.add(guard)
    signals.install()
    raised(INT)
    assert guard.triggered.wait(10)


def test_a_signal_waits_for_a_function_that_must_not_be_interrupted(context: Context) -> None:
    signals.install()
    interruptions = list[int]()

    def start() -> None:
        signal.raise_signal(INT)
        interruptions.append(context.interruptions)

    with pytest.raises(KeyboardInterrupt):  # noqa: PT012 - the signal comes again after 5 ms
        without_interruption(start)
        threading.Event().wait(10)
    assert (interruptions, context.interruptions) == ([0], 1)


# -- Ctrl-C ----------------------------------------------------------------------------------------


def test_ctrl_c_raises_a_keyboard_interrupt_without_a_traceback() -> None:
    signals.install()
    error = raised(INT)
    assert error is not None
    assert issubclass(error, KeyboardInterrupt)
    assert issubclass(error, SystemExit)


def test_the_hook_of_ctrl_c_gives_other_exceptions_to_the_hook_before(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    others: list[BaseException] = []
    monkeypatch.setattr(sys, "excepthook", lambda _, value, __: others.append(value))
    monkeypatch.setattr(signals, "_NEEDS_HOOK", True)
    signals.install()
    assert [raised(INT), raised(INT)] == [Interrupted] * 2
    mistake = ValueError()
    for error in (Interrupted(INT), mistake):
        sys.excepthook(type(error), error, None)
    assert others == [mistake]
    assert signals._Process.ends_by == INT


def test_ctrl_c_at_a_prompt_raises_pythons_keyboard_interrupt(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(sys, "ps1", ">>> ", raising=False)
    signals.install()
    assert raised(INT) is KeyboardInterrupt


# -- SIGTERM ---------------------------------------------------------------------------------------


def test_sigterm_ends_the_spinning_of_the_main_thread() -> None:
    signals.install()
    MainThread.spinning.add("executor")
    error = raised(TERM)
    assert error is not None
    assert issubclass(error, ExternalShutdownException)


def test_sigterm_lets_a_program_end_that_looks_at_ok(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(signals, "_LOOK_TIMEOUT_S", 0.05)
    signals.install()
    assert raised(TERM) is None
    signals.note_look()
    threading.Event().wait(0.2)  # longer than SIGTERM waits


def test_only_the_main_thread_looks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(signals, "_LOOK_TIMEOUT_S", 0.05)
    signals.install()
    assert raised(TERM) is None
    in_thread(signals.note_look)
    with pytest.raises(SystemExit):
        threading.Event().wait(10)


def test_sigterm_ends_a_program_that_does_not_look(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(signals, "_LOOK_TIMEOUT_S", 0.05)
    signals.install()
    assert raised(TERM) is None
    with pytest.raises(SignalExit):
        threading.Event().wait(10)


def test_a_second_sigterm_ends_the_program_at_once() -> None:
    signals.install()
    assert raised(TERM) is None
    assert raised(TERM) is SignalExit


# -- exceptions ------------------------------------------------------------------------------------


def test_what_needs_a_session_ends_the_program_that_has_not_noticed_sigterm() -> None:
    signals.install()
    with pytest.raises(NotInitializedError):
        signals.raise_not_initialized("a node")
    raised(TERM)
    with pytest.raises(ExternalShutdownException):
        signals.raise_not_initialized("a node")


def test_a_thread_of_the_program_gets_the_exception_of_a_shutdown() -> None:
    errors = list[BaseException]()

    def spin() -> None:
        try:
            signals.raise_shutdown(by_signal=False)
        except BaseException as error:  # noqa: BLE001 - also of the end of the process
            errors.append(error)

    in_thread(spin)
    assert [type(error) for error in errors] == [ExternalShutdownException]


def test_a_thread_ends_without_output_while_the_process_ends(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    errors = list[BaseException]()
    monkeypatch.setattr("zbot.process.at_exit._Process.is_ending", True)

    def note(end: Callable[[], object]) -> None:
        try:
            end()
        except BaseException as error:  # noqa: BLE001 - also of the end of the process
            errors.append(error)

    in_thread(lambda: note(lambda: signals.raise_shutdown(by_signal=False)))
    in_thread(lambda: note(lambda: signals.raise_not_initialized("a node")))
    assert [type(error) for error in errors] == [SystemExit, SystemExit]
