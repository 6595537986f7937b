"""The functions of a first program: `init`, `spin`, `ok`, `shutdown`."""

from __future__ import annotations

import contextlib
from typing import TYPE_CHECKING, Any

from zbot.context import get_default_context
from zbot.errors import NotInitializedError
from zbot.executor.executor import SingleThreadedExecutor
from zbot.node.endpoint import RMW_IDENTIFIER
from zbot.node.node import Node
from zbot.process import signals
from zbot.process.signals import SignalHandlerOptions

if TYPE_CHECKING:
    from collections.abc import Iterator
    from types import TracebackType

    from zbot.context import Context
    from zbot.executor.executor import Executor
    from zbot.executor.task import Future

_executors: dict[int, Executor] = {}


class InitContextManager:
    """What `init()` returns: leave the `with` block, and the context is shut down.

    Args:
        context: The context that was initialised.
    """

    def __init__(self, context: Context) -> None:
        self.context = context

    def __enter__(self) -> InitContextManager:
        return self

    def __exit__(
        self,
        exc_type: type[BaseException] | None,
        exc_val: BaseException | None,
        exc_tb: TracebackType | None,
    ) -> None:
        try_shutdown(context=self.context)


def init(
    *,
    args: list[str] | None = None,
    context: Context | None = None,
    domain_id: int | None = None,
    signal_handler_options: SignalHandlerOptions | None = None,
) -> InitContextManager:
    """Begin: read the command line, choose the domain, and see to it that Ctrl-C ends cleanly.

    Args:
        args: The command line with its `--ros-args`; `sys.argv` if left out.
        context: The context to initialise; the default one if left out.
        domain_id: 0 to 232; from the environment if left out.
        signal_handler_options: Which signals to handle; all for the default context, else none.

    Raises:
        ContextInitializedError: It was called before, without a `shutdown()` since.
        ArgumentsError: The `--ros-args` are malformed.
        DomainIdError: The domain is out of range.
    """
    default = context is None
    context = get_default_context() if context is None else context
    if signal_handler_options is None:
        signal_handler_options = SignalHandlerOptions.ALL if default else SignalHandlerOptions.NO
    signals.install(signal_handler_options)
    context.init(args, domain_id=domain_id)
    return InitContextManager(context)


def ok(*, context: Context | None = None) -> bool:
    """Return whether to go on: initialised, not shut down, no Ctrl-C yet."""
    return (get_default_context() if context is None else context).ok()


def shutdown(*, context: Context | None = None, uninstall_handlers: bool | None = None) -> None:
    """End: close the context's session and everything in it.

    The default context may be shut down twice: a first program ends like that after Ctrl-C.

    Args:
        context: The context to shut down; the default one if left out.
        uninstall_handlers: Whether to give the signals back; done for the default context.

    Raises:
        NotInitializedError: The given context is not initialised, or was shut down before.
    """
    if context is not None and not context.is_valid:
        raise NotInitializedError("shutdown(context=...)")
    try_shutdown(context=context, uninstall_handlers=uninstall_handlers)


def try_shutdown(*, context: Context | None = None, uninstall_handlers: bool | None = None) -> None:
    """Do what `shutdown()` does if that has not been done yet."""
    chosen = get_default_context() if context is None else context
    executor = _executors.pop(id(chosen), None)
    if executor is not None:
        executor.shutdown(0)  # first, so that whoever is in `spin()` returns without an exception
    chosen.shutdown()
    if uninstall_handlers or (uninstall_handlers is None and context is None):
        signals.uninstall()


def create_node(node_name: str, **options: Any) -> Node:
    """Create a node; the options are those of `Node`."""
    return Node(node_name, **options)


def get_global_executor(context: Context | None = None) -> Executor:
    """Return the executor that the module's `spin` functions use."""
    context = get_default_context() if context is None else context
    executor = _executors.get(id(context))
    if executor is None or executor.context is not context:
        executor = _executors[id(context)] = SingleThreadedExecutor(context=context)
    return executor


@contextlib.contextmanager
def _holding(node: Node, executor: Executor | None) -> Iterator[Executor]:
    executor = _executor_of(node) if executor is None else executor
    before = node.executor
    added = executor.add_node(node)
    try:
        yield executor
    finally:
        if added:
            executor.remove_node(node)
            if before is not None and not before.is_shutdown:
                before.add_node(node)


def _executor_of(node: Node) -> Executor:
    # Who is spun already stays where it is: the global executor would take it away.
    executor = node.executor
    if executor is not None and executor.is_spinning:
        return executor
    return get_global_executor(node.context)


def spin(node: Node, executor: Executor | None = None) -> None:
    """Run a node's callbacks until its context is shut down.

    Returns when a callback or another thread calls `shutdown()`.

    Raises:
        KeyboardInterrupt: Ctrl-C; nothing is printed when nobody catches it.
        ExternalShutdownException: The context was shut down by a signal, or by its own method.
    """
    with _holding(node, executor) as chosen:
        chosen.spin()


def spin_once(
    node: Node, *, executor: Executor | None = None, timeout_sec: float | None = None
) -> None:
    """Run one callback, waiting for it at most `timeout_sec` seconds (`None`: for ever)."""
    with _holding(node, executor) as chosen:
        chosen.spin_once(timeout_sec)


def spin_until_future_complete(
    node: Node,
    future: Future[Any],
    executor: Executor | None = None,
    timeout_sec: float | None = None,
) -> None:
    """Run a node's callbacks until the future is done, at most `timeout_sec` seconds."""
    with _holding(node, executor) as chosen:
        chosen.spin_until_future_complete(future, timeout_sec)


def get_rmw_implementation_identifier() -> str:
    """Return what carries the messages, as ROS 2's programs ask for it."""
    return RMW_IDENTIFIER


def get_available_rmw_implementations() -> set[str]:
    """Return everything that could carry the messages: there is one."""
    return {get_rmw_implementation_identifier()}
