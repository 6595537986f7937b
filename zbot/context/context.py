"""Context of a process: one domain and one Zenoh session, from `init()` to `shutdown()`."""

from __future__ import annotations

import contextlib
import sys
from typing import TYPE_CHECKING, Any, Literal, Protocol

import zenoh

from zbot.context.domain_session import DomainSession
from zbot.context.session_threads import SessionThreads
from zbot.context.state import ContextState
from zbot.graph.snapshot import Graph
from zbot.log import get_logger
from zbot.parameters.lost_arguments import warning_about
from zbot.parameters.ros_args import Arguments, configure_logging
from zbot.process import at_exit, blocked_put, fork, signals
from zbot.threads.foreign_call import defers_signals
from zbot.threads.handle import Handle
from zbot.threads.weak_set import WeakSet
from zbot.transport import shared_memory

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from typing_extensions import Self

    from zbot.graph.snapshot import Token
    from zbot.wire.dialect import Dialect


class NodeHandle(Protocol):
    """The part of a node's state that a context uses."""

    def leave_to_parent(self) -> None:
        """In a forked child, leave all entities of the node to the parent process."""
        ...


class ContextNode(Protocol):
    """The part of a node that a context uses."""

    @property
    def handle(self) -> NodeHandle:
        """The internal state of the node."""
        ...

    @property
    def executor(self) -> at_exit.Executor | None:
        """The executor that runs the node's callbacks, if any."""
        ...

    def destroy_node(self) -> object:
        """Remove the node from the graph."""
        ...


class Context(ContextState):
    """Domain and Zenoh session that the nodes of a process share.

    The first node opens the session. All methods may be called from any thread.

    Args:
        mode: `peer` for a process with nodes, or `client` for a tool. A client connects only to the
            domain's router, and gets the complete graph with its first query.
        rmw: The middleware, which decides the format of keys and messages: `rmw_zbot_zenoh` for
            zbot's own format, or `rmw_zenoh_cpp` for ROS 2's format. `None` means
            `$RMW_IMPLEMENTATION`, else the middleware in the Zenoh configuration file, else
            `rmw_zbot_zenoh`. Contexts of one process may have different middlewares.
    """

    def __init__(self, *, mode: Literal["peer", "client"] = "peer", rmw: str | None = None) -> None:
        super().__init__()
        self._threads = SessionThreads()
        self._domain_session = DomainSession(mode, rmw, self.receiver, self._note_open)
        self._graph: Graph | None = None
        self._nodes: WeakSet[ContextNode] = WeakSet()
        self.arguments = Arguments()

    def init(
        self,
        args: list[str] | None = None,
        *,
        initialize_logging: bool = True,
        domain_id: int | None = None,
    ) -> None:
        """Read the arguments and the domain, without opening a session.

        Args:
            args: The whole command line, including `--ros-args`. `None` means `sys.argv`.
            initialize_logging: Whether the log options of the arguments apply.
            domain_id: 0 to 232. In a classroom, `None` means the student's number. Otherwise it
                means `$ZBOT_DOMAIN_ID`, else `$ROS_DOMAIN_ID`, else 0.

        Raises:
            WrongStateError: `init` was called before.
            ArgumentsError: The `--ros-args` are malformed.
            UnicodeEncodeError: The `args` contain half a surrogate pair. rclpy raises this error
                too.
            SettingError: The domain is out of range, or the context's middleware is not known.
        """
        "".join(args or ()).encode()
        with self._lock:
            self._require_new()
            self._domain_session.choose_domain(domain_id)
            self.arguments = Arguments.parse(sys.argv if args is None else args)
            if initialize_logging:
                configure_logging(self.arguments)
            if lost := warning_about(self.arguments.unparsed):
                get_logger("zbot").warning(lost)
            self._begin()
            signals.add_context(self)

    def get_domain_id(self) -> int:
        """Return the domain, 0 to 232."""
        self.require_valid("get_domain_id()")
        return self._domain_session.domain

    @property
    def is_tool(self) -> bool:
        """Whether this is the context of a tool, e.g. a command. A tool is the router's client."""
        return self._domain_session.is_tool

    @property
    def is_student(self) -> bool:
        """Whether this is a student's machine in a classroom."""
        return self._domain_session.is_student

    @property
    def dialect(self) -> Dialect:
        """The format of keys and messages."""
        return self._domain_session.dialect

    @property
    def is_closed(self) -> bool:
        """Whether there is no open session."""
        return self._domain_session.is_closed

    @contextlib.contextmanager
    def until_shutdown(self, what: str) -> Iterator[None]:
        """Raise `NotInitializedError` if another thread shuts the context down within the block.

        Otherwise, the block would raise Zenoh's error about a closed session.

        Args:
            what: The subject of the error's sentence.
        """
        try:
            yield
        except zenoh.ZError:
            if self.is_closed:
                signals.raise_not_initialized(what)
            raise

    def leave_to_parent(self) -> None:
        """In a forked child, leave the session and all entities to the parent process.

        As in rclpy, `ok()` is still true, and `shutdown()` and `destroy_node()` have no effect on
        the parent. All that needs the session raises a `ForkedProcessError`.
        """
        fork.keep(self, dict(vars(self)))
        super().leave_to_parent()
        for executor in self.executors:
            executor.leave_to_parent()
        for node in self._nodes:
            fork.keep(node)
            node.handle.leave_to_parent()
        self._domain_session.leave_to_parent()
        self._graph, self._threads = None, SessionThreads()

    def undeclare(self, *declarations: Any) -> None:
        """Undeclare Zenoh objects, or do nothing if the session is closed."""
        if self.is_inherited:
            fork.keep(*declarations)
        elif not self.is_closed:
            for declaration in declarations:
                declaration.undeclare()

    def __enter__(self) -> Self:
        if self._state == "new":
            self.init()
        return self

    def __exit__(self, *exc_info: object) -> None:
        self.shutdown()

    @property
    def handle(self) -> Handle[Context]:
        """A handle of the context, as in rclpy."""
        return Handle(self)

    def add_node(self, node: ContextNode, name: str) -> None:
        """Add a node, with a weak reference.

        Args:
            node: The node.
            name: The node's full name.
        """
        self._nodes.add(node)
        self._domain_session.add_node(name)

    def remove_node(self, node: ContextNode, name: str) -> None:
        """Remove a node. The arguments are those of `add_node`."""
        self._nodes.discard(node)
        self._domain_session.remove_node(name)

    @property
    def nodes(self) -> list[ContextNode]:
        """The nodes that are not destroyed."""
        return list(self._nodes)

    @property
    def executors(self) -> set[at_exit.Executor]:
        """The executors of the context's nodes."""
        return {node.executor for node in self._nodes if node.executor is not None}

    @property
    def session(self) -> zenoh.Session:
        """The Zenoh session, opened at first use.

        Raises:
            NotInitializedError: `init()` was not called, or `shutdown()` was called.
            SessionError: Zenoh cannot open the session.
            SettingError: The Zenoh configuration file cannot be read or is invalid.
        """
        if self._domain_session.session is None:
            with self._lock:
                if self._domain_session.session is None:
                    self.require_valid("a node")
                    self._domain_session.open(lambda: self.is_over)
        session = self._domain_session.session
        if session is None or self._state != "valid":
            signals.raise_not_initialized("a node")
        return session

    def share(self, payload: bytes) -> Any:
        """Return a large payload. Put it into shared memory if the session uses shared memory."""
        return shared_memory.place(payload) if self._domain_session.shares_memory else payload

    @property
    def graph(self) -> Graph:
        """The graph of the domain, as this context's session sees it."""
        if self._graph is None:
            with self._lock:
                if self._graph is None:
                    self._graph = Graph(
                        self.session,
                        self.dialect,
                        self._domain_session.domain,
                        asks_first=self._domain_session.asks_router,
                        settle=self.wait_for_discovery,
                        receiver=self.receiver,
                        start_thread=self.start_thread,
                        is_running=lambda: self.is_running,
                    )
        return self._graph

    @property
    def zid(self) -> str:
        """The session's Zenoh id, lower-case hex."""
        return str(self.session.info.zid())

    def connect(self, *, wait: bool = False) -> bool:
        """Open a client's session if the domain has a router.

        Args:
            wait: Whether to start the domain's router if there is none. Nodes that start later
                connect to this router.

        Returns:
            Whether the session is open.
        """
        with self._lock:
            self.require_valid("connect()")
            if self._domain_session.session is None:
                self._domain_session.open_tool(wait=wait)
            return self._domain_session.session is not None

    def unreachable_tokens(self) -> list[Token]:
        """Return the tokens of sessions from which no message can come to this session."""
        zids, keys = self._domain_session.unreachable()
        return [token for token in self.graph.tokens_in(keys) if token.zid in zids]

    def wait_for_discovery(self) -> None:
        """Wait until every session of the domain has answered this session, at most 2 s."""
        self._domain_session.wait_for_discovery()

    def wait_for_peers(self) -> None:
        """Wait until this session knows all present subscriptions, at most 0.5 s."""
        self._domain_session.wait_for_peers()

    def _note_open(self) -> None:
        at_exit.open_contexts.add(self)
        at_exit.register()
        fork.register()

    @property
    def sessions(self) -> list[zenoh.Session]:
        """The nodes' session, if it is open."""
        return [] if self._domain_session.session is None else [self._domain_session.session]

    def start_thread(
        self, name: str, run: Callable[[], None], wake: Callable[[], object] = bool
    ) -> None:
        """Run a function in a thread that `shutdown()` waits for (see `SessionThreads.start`)."""
        self._threads.start(name, run, wake)

    def receiver(self, receive: Callable[[Any], object], *, may_wait: bool = False) -> Any:
        """Return a Zenoh handler that calls a function (see `SessionThreads.receiver`)."""
        return self._threads.receiver(receive, may_wait=may_wait)

    @defers_signals
    def close(self) -> None:
        """Close the session, also after a signal has interrupted `shutdown()`."""
        self._domain_session.close(self._threads.join)
        signals.contexts.discard(self)
        at_exit.open_contexts.discard(self)
        if not at_exit.open_contexts:
            blocked_put.unwatch_signals()
