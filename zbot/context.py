"""A context: one Zenoh session, one domain, and the life from `init()` to `shutdown()`."""

from __future__ import annotations

import itertools
import sys
import threading
import time
from typing import TYPE_CHECKING, Any, Literal, Protocol

import zenoh

from zbot.errors import ArgumentTypeError, ContextInitializedError, NotInitializedError
from zbot.graph.snapshot import Graph
from zbot.log import configure, get_logger, get_logging_severity_from_string
from zbot.log.announcement import NOTICE_KEY, log_notice
from zbot.parameters.ros_args import Arguments
from zbot.process import at_exit, blocked_put
from zbot.process.memory import spare_the_collector
from zbot.transport import config, membership, shared_memory
from zbot.transport.foreign_call import in_one_go, uninterrupted
from zbot.transport.handle import Handle
from zbot.transport.peering import Peering
from zbot.transport.session import MeetingPoint, process_facts
from zbot.transport.weak_set import WeakSet
from zbot.version import __version__
from zbot.wire.dialect import IN_CLASS, NATIVE

if TYPE_CHECKING:
    from collections.abc import Callable
    from types import TracebackType

    from typing_extensions import Self

# A meeting point answers within 10 ms; within seconds where 40 nodes start at once on two cores.
_LINK_TIMEOUT_S = 5.0
# Linux may refuse a port to both of two processes that take it within the same microseconds (6 of
# 100 times), as those of a launch file do: whoever finds nobody behind it tries again so often.
_HOLD_PAUSE_S = 0.1
# The longest that a first look at the graph, and a first message, wait: 2 ms are usual, a busy
# machine needs more.
_SETTLE_TIMEOUT_S = 2.0
_MEET_TIMEOUT_S = 0.5
# Multicast finds the others on a quiet network in 50 ms; nobody may be there.
_FIND_TIMEOUT_S = 0.7
_JOIN_TIMEOUT_S = 2.0  # threads end within a millisecond of their session


class ContextNode(Protocol):
    """What a context uses of a node."""

    @property
    def handle(self) -> object:
        """The node's inner part."""
        ...

    @property
    def executor(self) -> at_exit.Executor | None:
        """The executor that runs the node's callbacks, if any."""
        ...

    def destroy_node(self) -> object:
        """Remove the node from the graph."""
        ...


class Context:
    """What the nodes of a process share.

    The session is opened when the first node needs it. All methods may be called from any thread.

    Args:
        mode: `peer` for a process with nodes; `client` for a tool that only looks in, through the
            domain's router, and sees everything with its first query.
    """

    def __init__(self, *, mode: Literal["peer", "client"] = "peer") -> None:
        self._mode = mode
        self._lock = threading.RLock()
        self._state: Literal["new", "valid", "shut down"] = "new"
        self._interrupted = False
        self._session: zenoh.Session | None = None
        self._meeting: MeetingPoint | None = None
        self._watch: Peering | None = None
        self._graph: Graph | None = None
        self._wakers: list[Callable[[], None]] = []
        self._on_shutdown: list[Callable[[], None]] = []
        self._threads: dict[threading.Thread, Callable[[], object]] = {}
        # Weak: a signal may come between the making of one and the call that hands it to Zenoh.
        self._receivers: WeakSet[threading.Event] = WeakSet()
        self._entity_ids = itertools.count()
        self._nodes: WeakSet[ContextNode] = WeakSet()
        self.arguments = Arguments()
        self.dialect = NATIVE
        self._in_class = False
        self.is_student = False  #: whether this machine takes part in a class as a student's

    # -- life ----------------------------------------------------------------------------------

    def init(
        self,
        args: list[str] | None = None,
        *,
        initialize_logging: bool = True,
        domain_id: int | None = None,
    ) -> None:
        """Read the arguments and the domain. Nothing is opened yet.

        Args:
            args: The command line with its `--ros-args`; `sys.argv` if left out.
            initialize_logging: Whether log options among the arguments take effect.
            domain_id: 0 to 232; `$ZBOT_DOMAIN_ID` or `$ROS_DOMAIN_ID`, else 0, if left out.

        Raises:
            ContextInitializedError: It was called before.
            ArgumentsError: The `--ros-args` are malformed.
            UnicodeEncodeError: The given `args` have half a surrogate pair, as in rclpy.
            DomainIdError: The domain is out of range.
        """
        "".join(args or ()).encode()
        with self._lock:
            if self._state != "new":
                raise ContextInitializedError
            self._domain = config.domain_id(domain_id)
            self.arguments = Arguments.parse(sys.argv if args is None else args)
            joined = membership.load()
            self._in_class = joined is not None and joined.in_class
            self.is_student = joined is not None and joined.role == "student"
            self.dialect = IN_CLASS if self._in_class else NATIVE
            if initialize_logging:
                _configure_logging(self.arguments)
            self._state = "valid"

    def ok(self) -> bool:
        """Return whether it is initialised, not shut down and not interrupted by a signal."""
        return self._state == "valid" and not self._interrupted

    def get_domain_id(self) -> int:
        """Return the domain, 0 to 232."""
        self._require("get_domain_id()")
        return self._domain

    @property
    def is_closed(self) -> bool:
        """Whether there is no open session (any more)."""
        return self._session is None or self._session.is_closed()

    @property
    def is_valid(self) -> bool:
        """Whether it is initialised and not shut down; a signal may have interrupted it."""
        return self._state == "valid"

    @property
    def is_over(self) -> bool:
        """Whether it was shut down: it cannot be initialised again."""
        return self._state == "shut down"

    @property
    def is_interrupted(self) -> bool:
        """Whether a signal asked everything to end."""
        return self._interrupted

    def interrupt(self) -> None:
        """Let everything that spins end; publishing stays possible until `shutdown()`."""
        self._interrupted = True
        self._wake()

    def shutdown(self) -> None:
        """Close the session and everything in it; the second call does nothing."""
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
        """Shut down if that has not been done yet."""
        self.shutdown()

    def destroy(self) -> None:
        """Shut down."""
        self.shutdown()

    def on_shutdown(self, callback: Callable[[], None]) -> None:
        """Call a function once, at the beginning of `shutdown()`; also before `init()`.

        Raises:
            ArgumentTypeError: It is no function.
        """
        if not callable(callback):
            raise ArgumentTypeError("callback", "a function", callback)
        self._on_shutdown.append(callback)

    def add_waker(self, waker: Callable[[], None]) -> None:
        """Call a quick function whenever somebody who waits should look at `ok()` again."""
        with self._lock:
            self._wakers.append(waker)

    def remove_waker(self, waker: Callable[[], None]) -> None:
        """Stop calling a function; nothing happens if it is unknown."""
        with self._lock:
            if waker in self._wakers:
                self._wakers.remove(waker)

    @uninterrupted
    def _wake(self) -> None:
        for waker in list(self._wakers):
            waker()

    def _require(self, what: str) -> None:
        if self._state != "valid":
            raise NotInitializedError(what)

    def __enter__(self) -> Self:
        if self._state == "new":
            self.init()
        return self

    def __exit__(
        self,
        exc_type: type[BaseException] | None,
        exc_val: BaseException | None,
        exc_tb: TracebackType | None,
    ) -> None:
        self.shutdown()

    @property
    def handle(self) -> Handle[Context]:
        """Rclpy's name for the context's inner part."""
        return Handle(self)

    # -- nodes ---------------------------------------------------------------------------------

    def add_node(self, node: ContextNode) -> None:
        """Keep track of a node, weakly."""
        self._nodes.add(node)

    def remove_node(self, node: ContextNode) -> None:
        """Forget a node."""
        self._nodes.discard(node)

    @property
    def nodes(self) -> list[ContextNode]:
        """The nodes that were created and not yet destroyed."""
        return list(self._nodes)

    @property
    def executors(self) -> set[at_exit.Executor]:
        """The executors that its nodes are in."""
        return {node.executor for node in self._nodes if node.executor is not None}

    # -- session -------------------------------------------------------------------------------

    @property
    def session(self) -> zenoh.Session:
        """The Zenoh session, opened at first use.

        Raises:
            NotInitializedError: Before `init()` or after `shutdown()`.
            SessionError: Zenoh cannot open one.
            ConfigError: The Zenoh configuration file is unusable.
        """
        if self._session is None:
            with self._lock:
                if self._session is None:
                    self._require("a node")
                    self._open()
        session = self._session
        if session is None or self._state != "valid":
            raise NotInitializedError("a node")
        return session

    def share(self, payload: bytes) -> Any:
        """Return a large payload in memory that this machine's programs share, if they may."""
        shares = self._meeting is not None and self._meeting.shares_memory
        return shared_memory.place(payload) if shares else payload

    @property
    def graph(self) -> Graph:
        """Who is there in the domain, seen through this context's session."""
        if self._graph is None:
            with self._lock:
                if self._graph is None:
                    self._graph = Graph(
                        self.session,
                        self.dialect,
                        self._domain,
                        asks_first=self._mode == "client",
                        settle=self.settle,
                        receiver=self.receiver,
                    )
        return self._graph

    @property
    def zid(self) -> str:
        """The session's Zenoh id, lower-case hex."""
        return str(self.session.info.zid())

    def next_entity_id(self) -> int:
        """Return a number that no other node or endpoint of the context has."""
        return next(self._entity_ids)

    def connect(self, *, wait: bool = False) -> bool:
        """Open a client's session if anybody is there.

        Args:
            wait: Keep the meeting port open oneself when nobody does, so that others can come
                later.

        Returns:
            Whether there is a session now.
        """
        with self._lock:
            self._require("connect()")
            if self._session is None:
                self._open_client(self._new_meeting(), wait=wait)
            return self._session is not None

    def settle(self) -> None:
        """Wait, at most 2 s, until every session of the domain has answered this one."""
        watch = self._watch
        if watch is not None and self._mode == "peer" and not self.session.is_closed():
            watch.wait_settled(_SETTLE_TIMEOUT_S)

    def meet(self) -> None:
        """Wait, at most 0.5 s, until everybody's present subscriptions are known here."""
        if self._mode == "peer" and self._watch is not None:
            self._watch.wait_settled(_MEET_TIMEOUT_S)

    def _new_meeting(self) -> MeetingPoint:
        reach = config.discovery_range()
        return MeetingPoint(config.load(), self._domain, reach, process_facts(__version__))

    def _open(self) -> None:
        meeting = self._new_meeting()
        if self._mode == "client":
            self._open_client(meeting, wait=True)
            return
        meeting.hold()
        session = meeting.open_peer()
        self._adopt(session, meeting)
        if self._in_class:
            in_one_go(session.declare_subscriber, NOTICE_KEY, self.receiver(log_notice))
        self._check_linked(meeting)

    def _open_client(self, meeting: MeetingPoint, *, wait: bool) -> None:
        session, deadline = meeting.open_client(), time.monotonic() + _LINK_TIMEOUT_S
        while session is None and (wait or meeting.reaches_out):
            if meeting.hold():
                meeting.wait_found(_FIND_TIMEOUT_S)
            session = meeting.open_client()
            if session is None:
                if time.monotonic() > deadline:
                    break
                time.sleep(_HOLD_PAUSE_S)
        if session is not None:
            self._adopt(session, meeting, watch=wait)

    def _adopt(self, session: zenoh.Session, meeting: MeetingPoint, *, watch: bool = True) -> None:
        # In this order: a Ctrl-C in between must find everything that is to be closed.
        self._session, self._meeting = session, meeting
        at_exit.open_contexts.add(self)
        at_exit.hook()
        if watch:
            self._watch = Peering(session, meeting, self.receiver)
            self._watch.start()

    def _check_linked(self, meeting: MeetingPoint) -> None:
        watch, deadline = self._watch, time.monotonic() + _LINK_TIMEOUT_S
        pause_s = _HOLD_PAUSE_S
        if watch is None or config.discovery_range() is config.DiscoveryRange.OFF:
            return
        while not watch.wait_linked(min(pause_s, deadline - time.monotonic())):
            if self.is_over:
                return
            if time.monotonic() >= deadline:
                get_logger("zbot").warning(
                    f"nobody answers as zbot on {meeting.endpoint}: another program may use that "
                    "port; other nodes will not be found (choose another domain: ZBOT_DOMAIN_ID=7)"
                )
                return
            meeting.hold()
            pause_s *= 2

    @property
    def sessions(self) -> list[zenoh.Session]:
        """What is open: the session, and the router that the domain meets at, if it is here."""
        router = None if self._meeting is None else self._meeting.router
        return [one for one in (self._session, router) if one is not None]

    def start_thread(
        self, name: str, run: Callable[[], None], wake: Callable[[], object] = bool
    ) -> None:
        """Run a function in a thread that `shutdown()` waits for.

        Python kills the threads that are left at its end, and one that is inside Zenoh then takes
        the whole process down.

        Args:
            name: Shown by debuggers.
            run: Must end when the session is closed and `wake` was called.
            wake: Called after the session was closed.
        """

        def body() -> None:
            try:
                run()
            finally:
                self._threads.pop(thread, None)

        thread = threading.Thread(target=body, name=name, daemon=True)
        self._threads[thread] = wake
        in_one_go(thread.start)

    def receiver(self, receive: Callable[[Any], object]) -> Any:
        """Return what Zenoh calls a function through, in a thread that `shutdown()` waits for.

        That thread is Zenoh's own and sleeps until something comes; one of ours that waits for a
        channel of Zenoh's is woken ten times a second. It has room for 256 events, and the session
        stands still while that is full.

        Args:
            receive: Must be quick.
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
            # One whose start was interrupted by a signal has no ident.
            if thread is not threading.current_thread() and thread.ident is not None:
                thread.join(_JOIN_TIMEOUT_S)
        for ended in self._receivers:
            ended.wait(_JOIN_TIMEOUT_S)

    @uninterrupted
    def close(self) -> None:
        """Close the session: the last part of `shutdown()`, for when a signal interrupted that."""
        # The session first: that ends the threads which wait for its data (see docs/wire.md).
        if self._session is not None:
            blocked_put.release(self.sessions)
            self._session.close()
        self._join_threads()
        if self._watch is not None:
            self._watch.join()
        if self._meeting is not None:
            self._meeting.close()
        at_exit.open_contexts.discard(self)


def _configure_logging(arguments: Arguments) -> None:
    levels = {
        one.logger: get_logging_severity_from_string(one.level) for one in arguments.log_levels
    }
    configure(
        levels=levels,
        stdout_enabled=arguments.stdout_logs,
        rosout_enabled=arguments.rosout_logs,
        file_enabled=arguments.external_lib_logs,
        file_prefix=arguments.log_file_name,
    )


_default: Context | None = None
_default_lock = threading.Lock()


def get_default_context(*, shutting_down: bool = False) -> Context:
    """Return the process's context; a new one after the last was shut down.

    Args:
        shutting_down: Whether the last one will do, as for whoever is about to end it.
    """
    global _default  # noqa: PLW0603 - one per process is what it is
    with _default_lock:
        if _default is None or (_default.is_over and not shutting_down):
            _default = Context()
        return _default


spare_the_collector()
