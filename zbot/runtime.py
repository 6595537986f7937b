"""Functions for the default context and executor: `init`, `ok`, `spin`, `shutdown`."""

from __future__ import annotations

import threading
from functools import partial
from typing import TYPE_CHECKING, Any

from zbot.context import get_default_context
from zbot.errors import NotInitializedError
from zbot.executor.errors import not_an_executor_error
from zbot.executor.single_threaded_executor import SingleThreadedExecutor
from zbot.executor.spin_arguments import is_future
from zbot.executor.spinnable import check_node
from zbot.interfaces.unknown_field import add_advice
from zbot.node.argument_check import check_order, is_node
from zbot.node.node import Node
from zbot.process import error_advice, signals
from zbot.process.signals import SignalHandlerOptions
from zbot.transport.rmw_choice import IDENTIFIERS

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.context import Context
    from zbot.executor.executor import Executor
    from zbot.executor.task import Future

_executors: dict[int, Executor] = {}


class InitContextManager:
    """Context manager that `init()` returns. The end of its `with` block shuts the context down.

    Args:
        context: The context that was initialised.
    """

    def __init__(self, context: Context) -> None:
        self.context = context

    def __enter__(self) -> InitContextManager:
        return self

    def __exit__(self, *exc_info: object) -> None:
        try_shutdown(context=self.context)


def init(
    *,
    args: list[str] | None = None,
    context: Context | None = None,
    domain_id: int | None = None,
    signal_handler_options: SignalHandlerOptions | None = None,
) -> InitContextManager:
    """Initialise a context from the command line, and install signal handlers.

    Args:
        args: The command line with its `--ros-args`. `None` means `sys.argv`.
        context: The context to initialise. `None` means the default context.
        domain_id: 0 to 232. In a classroom, `None` means the student's number. Otherwise it means
            `$ZBOT_DOMAIN_ID`, else `$ROS_DOMAIN_ID`, else 0.
        signal_handler_options: The signals to handle. `None` means all signals for the default
            context, and no signals for another context.

    Raises:
        WrongStateError: The context is already initialised.
        ArgumentsError: The `--ros-args` are malformed.
        SettingError: The domain is out of range.
    """
    default = context is None
    context = get_default_context(initialising=True) if context is None else context
    if signal_handler_options is None:
        signal_handler_options = SignalHandlerOptions.ALL if default else SignalHandlerOptions.NO
    signals.install(signal_handler_options)
    if default:
        error_advice.install()
    context.init(args, domain_id=domain_id)
    return InitContextManager(context)


def ok(*, context: Context | None = None) -> bool:
    """Return whether the context is initialised, not shut down, and not interrupted."""
    return (get_default_context() if context is None else context).ok()


def shutdown(*, context: Context | None = None, uninstall_handlers: bool | None = None) -> None:
    """Shut down a context: close its session and all its entities.

    A program may shut down the default context twice. Simple programs do this after Ctrl-C.

    Args:
        context: The context to shut down. `None` means the default context.
        uninstall_handlers: Whether to restore the former signal handlers. `None` means true for the
            default context, and false for another context.

    Raises:
        NotInitializedError: The given context is not initialised, or is already shut down.
    """
    if context is not None and not context.is_valid:
        raise NotInitializedError("shutdown(context=...)")
    try_shutdown(context=context, uninstall_handlers=uninstall_handlers)


def try_shutdown(*, context: Context | None = None, uninstall_handlers: bool | None = None) -> None:
    """Shut down a context if it is not shut down yet. See `shutdown`."""
    chosen = get_default_context() if context is None else context
    executor = _executors.pop(id(chosen), None)
    if executor is not None:
        executor.shutdown(0)  # first, so that `spin()` returns without an exception
    chosen.shutdown()
    if uninstall_handlers or (uninstall_handlers is None and context is None):
        signals.uninstall()


def create_node(node_name: str, **options: Any) -> Node:
    """Create a node. The options are the arguments of `Node`."""
    return Node(node_name, **options)


def get_global_executor(context: Context | None = None) -> Executor:
    """Return the executor that the `spin` functions of this module use."""
    context = get_default_context() if context is None else context
    executor = _executors.get(id(context))
    if executor is None or executor.context is not context:
        executor = _executors[id(context)] = SingleThreadedExecutor(context=context)
        context.on_shutdown(partial(_executors.pop, id(context), None))
    return executor


def _spin(node: Node, executor: Executor | None, run: Callable[[Executor], None]) -> None:
    """Add the node to the executor, call a function with the executor, and remove the node."""
    check_node("spin", node)
    _check_context(node)
    if executor is None:
        executor = _executor_of(node)
    elif not hasattr(executor, "spin_once"):
        raise not_an_executor_error(executor)
    before = node.executor
    added = executor.add_node(node)
    try:
        run(executor)
    except AttributeError as error:
        add_advice(error)
        raise
    finally:
        if added and before is not None and not before.is_shutdown:
            before.add_node(node)
        elif added:
            executor.pause_node(node)  # a program often spins the same node again immediately


def _check_context(node: Node) -> None:
    # A thread may spin until the main thread shuts the context down, which is no mistake.
    is_late = node.context.is_over and threading.current_thread() is threading.main_thread()
    if node.context.is_inherited or (is_late and not node.context.is_interrupted):
        node.context.require_valid(f"the node {node.get_fully_qualified_name()}")


def _executor_of(node: Node) -> Executor:
    # A node stays in its executor if the executor spins. The global executor would remove the node
    # from that executor.
    executor = node.executor
    if executor is not None and executor.is_spinning:
        return executor
    return get_global_executor(node.context)


def spin(node: Node, executor: Executor | None = None) -> None:
    """Run a node's callbacks until its context is shut down.

    The call ends when a callback or another thread calls `shutdown()`.

    Raises:
        KeyboardInterrupt: The user pressed Ctrl-C. If no code catches it, no traceback is printed.
        ExternalShutdownException: A signal or `Context.shutdown()` shut the context down.
    """
    _spin(node, executor, lambda chosen: chosen.spin())


def spin_once(
    node: Node, *, executor: Executor | None = None, timeout_sec: float | None = None
) -> None:
    """Wait for one callback, at most `timeout_sec` seconds (`None`: no limit), and run it."""
    _spin(node, executor, lambda chosen: chosen.spin_once(timeout_sec))


def spin_until_future_complete(
    node: Node,
    future: Future[Any],
    executor: Executor | None = None,
    timeout_sec: float | None = None,
) -> None:
    """Run a node's callbacks until the future is done, at most `timeout_sec` seconds."""
    check_order("spin_until_future_complete", (node, is_node), (future, is_future))
    _spin(node, executor, lambda chosen: chosen.spin_until_future_complete(future, timeout_sec))


def get_rmw_implementation_identifier() -> str:
    """Return the name of the middleware of the default context."""
    return get_default_context().dialect.identifier


def get_available_rmw_implementations() -> set[str]:
    """Return the names of the middlewares that `RMW_IMPLEMENTATION` can choose."""
    return set(IDENTIFIERS)
