"""Context of a process: one domain and one Zenoh session, from `init()` to `shutdown()`."""

from __future__ import annotations

import os
import sys
import threading
from typing import TYPE_CHECKING, Any, Literal, Protocol

import zenoh

from zbot.errors import ArgumentTypeError, ContextInitializedError, ForkedProcessError
from zbot.graph.snapshot import Graph
from zbot.handle import Handle
from zbot.log import get_logger
from zbot.log.teacher_notice import NOTICE_KEY, log_notice
from zbot.parameters.lost_arguments import warning_about
from zbot.parameters.ros_args import Arguments, configure_logging
from zbot.process import at_exit, blocked_put, fork, signals
from zbot.threads.foreign_call import defers_signals, without_interruption
from zbot.threads.weak_set import WeakSet
from zbot.transport import config, environment, membership, shared_memory, zenoh_session
from zbot.transport.peering import Peering
from zbot.transport.process_facts import process_facts
from zbot.transport.rmw_choice import RMW_ZENOH, dialect_of_rmw
from zbot.transport.running_programs import Registration
from zbot.transport.session import MeetingPoint
from zbot.version import __version__
from zbot.wire.dialect import NATIVE

if TYPE_CHECKING:
    from collections.abc import Callable

    from typing_extensions import Self

    from zbot.graph.snapshot import Token
    from zbot.transport.rmw_meeting import RmwMeeting

# Longest waits before the first graph query and before the first message. Such a wait usually takes
# 2 ms.
_DISCOVERY_TIMEOUT_S = 2.0
_PEERS_TIMEOUT_S = 0.5
_JOIN_TIMEOUT_S = 2.0  # threads end within a millisecond after their session


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


class Context:
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
        self._mode = mode
        self._asks_router = mode == "client"
        self._rmw = rmw
        self._lock = threading.RLock()
        self._state: Literal["new", "valid", "shut down"] = "new"
        self._interrupted = False
        self.is_inherited = False  #: whether the parent of this forked process opened the session
        self._process: int | None = None  # id of the process that called `init`
        self._session: zenoh.Session | None = None
        self._meeting: MeetingPoint | RmwMeeting | None = None
        self._peering: Peering | None = None
        self._graph: Graph | None = None
        self._registration: Registration | None = None
        self._wakers: list[Callable[[], None]] = []
        self._on_shutdown: list[Callable[[], None]] = []
        self._threads: dict[threading.Thread, Callable[[], object]] = {}
        # The set is weak, because a signal's exception may come before Zenoh gets a receiver.
        # `close` must not wait for such a receiver.
        self._receivers: WeakSet[threading.Event] = WeakSet()
        self._nodes: WeakSet[ContextNode] = WeakSet()
        self.arguments = Arguments()
        self.dialect = NATIVE
        self._in_class = False
        self.is_student = False  #: whether this is a student's machine in a classroom

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
            ContextInitializedError: `init` was called before.
            ArgumentsError: The `--ros-args` are malformed.
            UnicodeEncodeError: The `args` contain half a surrogate pair. rclpy raises this
                error too.
            DomainIdError: The domain is out of range.
            RmwError: The context's middleware is not known.
        """
        "".join(args or ()).encode()
        with self._lock:
            if self._state != "new":
                raise ContextInitializedError
            self._domain, self._given_domain = config.domain_id(domain_id), domain_id
            self.arguments = Arguments.parse(sys.argv if args is None else args)
            joined = membership.load()
            self._in_class = joined is not None and joined.in_class
            self.is_student = joined is not None and joined.role == "student"
            self.dialect = dialect_of_rmw(self._rmw, in_class=self._in_class)
            if initialize_logging:
                configure_logging(self.arguments)
            if lost := warning_about(self.arguments.unparsed):
                get_logger("zbot").warning(lost)
            self._state, self._process = "valid", os.getpid()
            signals.contexts.add(self)

    def ok(self) -> bool:
        """Return whether the context is initialised, not shut down, and not interrupted.

        If SIGTERM interrupted the context and the main thread calls this, the program is expected
        to end on its own. Otherwise the signal ends it after 3 s.
        """
        if self._state == "valid" and not self._interrupted:
            return True
        signals.note_look()
        return False

    @property
    def is_running(self) -> bool:
        """Whether `ok()` is true. zbot reads this, because a call of `ok()` has an effect."""
        return self._state == "valid" and not self._interrupted

    def get_domain_id(self) -> int:
        """Return the domain, 0 to 232."""
        self.require_valid("get_domain_id()")
        return self._domain

    @property
    def is_tool(self) -> bool:
        """Whether this is the context of a tool, e.g. a command. A tool is the router's client."""
        return self._mode == "client"

    @property
    def is_closed(self) -> bool:
        """Whether there is no open session."""
        return self._session is None or self._session.is_closed()

    @property
    def is_valid(self) -> bool:
        """Whether the context is initialised and not shut down. It may be interrupted."""
        return self._state == "valid"

    @property
    def is_over(self) -> bool:
        """Whether the context was shut down. Such a context cannot be initialised again."""
        return self._state == "shut down"

    @property
    def is_of_parent(self) -> bool:
        """Whether the parent of this forked process has initialised the context."""
        return self._state == "valid" and self._process != os.getpid()

    @property
    def is_interrupted(self) -> bool:
        """Whether a signal interrupted the context."""
        return self._interrupted

    def interrupt(self) -> None:
        """Let all `spin` calls return. Publishing stays possible until `shutdown()`."""
        self._interrupted = True
        self._wake()

    def shutdown(self) -> None:
        """Close the session and all its entities. The second call does nothing."""
        with self._lock:
            if self._state != "valid":
                return
            self._state = "shut down"
            callbacks, self._on_shutdown = self._on_shutdown, []
        self._wake()
        try:
            for callback in callbacks:
                callback()
        finally:
            self.close()

    def try_shutdown(self) -> None:
        """Shut down if the context is not shut down yet."""
        self.shutdown()

    def destroy(self) -> None:
        """Shut down."""
        self.shutdown()

    def on_shutdown(self, callback: Callable[[], None]) -> None:
        """Add a callback that `shutdown()` calls first. Callbacks may be added before `init()`.

        Raises:
            ArgumentTypeError: The callback is not a function.
        """
        if not callable(callback):
            raise ArgumentTypeError("callback", "a function", callback)
        self._on_shutdown.append(callback)

    def add_waker(self, waker: Callable[[], None]) -> None:
        """Add a function that lets a waiting thread check `ok()` again. It must return quickly."""
        with self._lock:
            self._wakers.append(waker)

    def remove_waker(self, waker: Callable[[], None]) -> None:
        """Remove a function that was given to `add_waker`. Do nothing if it was not given."""
        with self._lock:
            if waker in self._wakers:
                self._wakers.remove(waker)

    @defers_signals
    def _wake(self) -> None:
        for waker in list(self._wakers):
            waker()

    def leave_to_parent(self) -> None:
        """In a forked child, leave the session and all entities to the parent process.

        As in rclpy, `ok()` is still true, and `shutdown()` and `destroy_node()` have no effect on
        the parent. All that needs the session raises a `ForkedProcessError`.
        """
        self.is_inherited = True
        fork.keep(self, dict(vars(self)))
        self._lock = threading.RLock()  # a thread of the parent may hold the old lock
        for executor in self.executors:
            executor.leave_to_parent()
        for node in self._nodes:
            fork.keep(node)
            node.handle.leave_to_parent()
        if self._registration is not None:
            self._registration.leave_to_parent()
        self._session = self._meeting = self._peering = self._graph = self._registration = None
        self._wakers, self._threads, self._receivers = [], {}, WeakSet()

    def undeclare(self, *declarations: Any) -> None:
        """Undeclare Zenoh objects, or do nothing if the session is closed."""
        if self.is_inherited:
            fork.keep(*declarations)
        elif not self.is_closed:
            for declaration in declarations:
                declaration.undeclare()

    def require_valid(self, what: str) -> None:
        """Check that the context is initialised and not shut down.

        Args:
            what: The subject of the error's sentence.

        Raises:
            ForkedProcessError: The context belongs to the parent of this forked process.
            NotInitializedError: The context is not initialised, or it was shut down.
        """
        if self.is_inherited:
            raise ForkedProcessError(what)
        if self._state != "valid":
            signals.raise_not_initialized(what)

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
        if self._registration is not None:
            self._registration.add(name)

    def remove_node(self, node: ContextNode, name: str) -> None:
        """Remove a node. The arguments are those of `add_node`."""
        self._nodes.discard(node)
        if self._registration is not None:
            self._registration.remove(name)

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
            ConfigError: The Zenoh configuration file cannot be read or is invalid.
        """
        if self._session is None:
            with self._lock:
                if self._session is None:
                    self.require_valid("a node")
                    self._open()
        session = self._session
        if session is None or self._state != "valid":
            signals.raise_not_initialized("a node")
        return session

    def share(self, payload: bytes) -> Any:
        """Return a large payload. Put it into shared memory if the session uses shared memory."""
        shares = self._meeting is not None and self._meeting.shares_memory
        return shared_memory.place(payload) if shares else payload

    @property
    def graph(self) -> Graph:
        """The graph of the domain, as this context's session sees it."""
        if self._graph is None:
            with self._lock:
                if self._graph is None:
                    self._graph = Graph(
                        self.session,
                        self.dialect,
                        self._domain,
                        asks_first=self._asks_router,
                        settle=self.wait_for_discovery,
                        receiver=self.receiver,
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
            if self._session is None:
                self._open_client(wait=wait)
            return self._session is not None

    def unreachable_tokens(self) -> list[Token]:
        """Return the tokens of sessions from which no message can come to this session."""
        meeting, zids = self._meeting, self._peering.unreachable() if self._peering else set()
        keys = meeting.router_tokens() if meeting is not None and zids else []
        return [one for one in self.graph.tokens_in(keys) if one.zid in zids]

    def wait_for_discovery(self) -> None:
        """Wait until every session of the domain has answered this session, at most 2 s."""
        peering = self._peering
        if peering is not None and not (self._asks_router or self.session.is_closed()):
            peering.wait_for_answers(_DISCOVERY_TIMEOUT_S)

    def wait_for_peers(self) -> None:
        """Wait until this session knows all present subscriptions, at most 0.5 s."""
        if not self._asks_router and self._peering is not None:
            self._peering.wait_for_answers(_PEERS_TIMEOUT_S)

    def _new_meeting(self) -> MeetingPoint | RmwMeeting:
        zenoh_session.prepare()
        reach, facts = config.discovery_range(), process_facts(__version__)
        file = config.load()
        self.dialect = dialect_of_rmw(self._rmw, in_class=self._in_class, file=file)
        if self.dialect.identifier == RMW_ZENOH:
            from zbot.transport.rmw_meeting import RmwMeeting  # noqa: PLC0415 - few programs need it

            return RmwMeeting(reach, facts, self._domain)
        environment.warn(self._given_domain)
        return MeetingPoint(file, self._domain, reach, facts)

    def _open(self) -> None:
        if self._mode == "client":
            self._open_client(wait=True)
            return
        meeting = self._new_meeting()
        meeting.start_router()
        session = meeting.open_node_session()
        self._set_session(session, meeting)
        if self._in_class:
            without_interruption(session.declare_subscriber, NOTICE_KEY, self.receiver(log_notice))
        if self._peering is not None:
            self._peering.link(lambda: self.is_over)

    def _open_client(self, *, wait: bool) -> None:
        meeting = self._new_meeting()
        session = meeting.open_tool_session(wait=wait)
        if session is not None:
            self._asks_router = meeting.is_client
            self._set_session(session, meeting, watch=wait)
        elif wait:  # without a router, use a node's session, which finds other nodes itself
            self._set_session(meeting.open_node_session(), meeting)

    def _set_session(
        self, session: zenoh.Session, meeting: MeetingPoint | RmwMeeting, *, watch: bool = True
    ) -> None:
        # The order matters: if Ctrl-C comes in between, `close` must find everything that is open.
        self._session, self._meeting = session, meeting
        self.dialect = meeting.dialect or self.dialect
        at_exit.open_contexts.add(self)
        at_exit.register()
        fork.register()
        if watch:
            self._registration = Registration(self._domain, is_tool=self.is_tool)
            self._peering = Peering(session, meeting, self.receiver)
            self._peering.start()

    @property
    def sessions(self) -> list[zenoh.Session]:
        """The nodes' session, if it is open."""
        return [] if self._session is None else [self._session]

    def start_thread(
        self, name: str, run: Callable[[], None], wake: Callable[[], object] = bool
    ) -> None:
        """Run a function in a thread that `shutdown()` waits for.

        Python kills the threads that still run at its exit. Killing a thread inside Zenoh crashes
        the process.

        Args:
            name: Name of the thread, for debuggers.
            run: The function, which must end after the session was closed and `wake` was called.
            wake: Called after the session was closed.
        """

        def body() -> None:
            try:
                run()
            finally:
                self._threads.pop(thread, None)

        thread = threading.Thread(target=body, name=name, daemon=True)
        self._threads[thread] = wake
        without_interruption(thread.start)

    def receiver(self, receive: Callable[[Any], object]) -> Any:
        """Return a Zenoh handler that calls a function in a thread that `shutdown()` waits for.

        The thread belongs to Zenoh and sleeps until an event comes. A Python thread that waited
        for a channel of Zenoh would wake up ten times a second. The handler's queue holds 256
        events, and a full queue blocks the session.

        Args:
            receive: The function, which must return quickly.
        """
        ended = threading.Event()

        def end() -> None:
            self._receivers.discard(ended)
            ended.set()

        self._receivers.add(ended)
        return zenoh.handlers.Callback(receive, drop=end)

    def _join_threads(self) -> None:
        for thread, wake in list(self._threads.items()):
            wake()
            # A thread whose start was interrupted by a signal has no ident.
            if thread is not threading.current_thread() and thread.ident is not None:
                thread.join(_JOIN_TIMEOUT_S)
        for ended in self._receivers:
            ended.wait(_JOIN_TIMEOUT_S)

    @defers_signals
    def close(self) -> None:
        """Close the session, also after a signal has interrupted `shutdown()`."""
        # The session is closed first, because this ends the threads that wait for its data.
        if self._session is not None:
            blocked_put.cancel_all(self.sessions)
            self._session.close()
        if self._registration is not None:
            self._registration.close()
        self._join_threads()
        if self._peering is not None:
            self._peering.join()
        if self._meeting is not None:
            self._meeting.close()
        signals.contexts.discard(self)
        at_exit.open_contexts.discard(self)
        if not at_exit.open_contexts:
            blocked_put.unwatch_signals()


_default: Context | None = None
_default_lock = threading.Lock()


def _renew_lock() -> None:
    global _default_lock  # noqa: PLW0603 - there is one per process
    _default_lock = threading.Lock()


fork.in_child.append(_renew_lock)


def get_default_context(*, shutting_down: bool = False, initialising: bool = False) -> Context:
    """Return the process's default context. If it was shut down, a new context replaces it.

    Args:
        shutting_down: Whether to return the last context even if it was shut down.
        initialising: Whether a new context also replaces a context of the parent process, in a
            forked child.
    """
    global _default  # noqa: PLW0603 - there is one per process
    with _default_lock:
        if (
            _default is None
            or (_default.is_over and not shutting_down)
            or (_default.is_of_parent and initialising)
        ):
            _default = Context()
        return _default
