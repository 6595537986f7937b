"""Warnings about typical mistakes: misspelt topics, two types on a topic, equal names of nodes.

Without a warning, the programs seem to work, but no message arrives. A thread of the context
compares the tokens when the graph has changed.
"""

from __future__ import annotations

import threading
from collections import Counter, deque
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import zenoh

from zbot.errors import NotInitializedError
from zbot.errors.call_source import calling_line
from zbot.errors.suggestion import KnownNames, did_you_mean, nearest, question
from zbot.graph.snapshot import Snapshot
from zbot.log import get_logger
from zbot.names import ROSOUT_TOPIC, SEND_GOAL, is_hidden
from zbot.process import fork
from zbot.threads.deadline import Deadline
from zbot.threads.on_demand_thread import OnDemandThread
from zbot.threads.weak_set import WeakSet
from zbot.transport import running_programs
from zbot.wire.keys import SHARED_DOMAIN
from zbot.wire.tokens import EndpointToken, EntityKind, NodeToken

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from zbot.context import Context
    from zbot.graph.snapshot import Token
    from zbot.parameters.store import ParameterStore

# A missing publisher or server is reported after this time, because its program may start later.
_CHECK_DELAY_S = 3.0
#: A node that nobody spins yet may declare its parameters so long after its start, because its
#: __init__ loads a model of a neural network before, for example.
_LONGEST_INIT_S = 30.0
_HISTORY_S = 0.3  # the tokens of the present endpoints of a type come within 25 ms
_STANDARD_TYPES = {
    ROSOUT_TOPIC: "rcl_interfaces/msg/Log",
    "/parameter_events": "rcl_interfaces/msg/ParameterEvent",
}
#: Parameters of every node.
_STANDARD_PARAMETERS = {"start_type_description_service", "use_sim_time"}
#: So many endpoints of one node with one name are made by mistake, e.g. in a callback.
MOST_EQUAL = 30
_KINDS = {
    EntityKind.PUBLISHER: "publishers of",
    EntityKind.SUBSCRIPTION: "subscriptions to",
    EntityKind.CLIENT: "clients of",
}
_VERBS = {EntityKind.PUBLISHER: "publishes", EntityKind.SUBSCRIPTION: "subscribes to"}

#: What an endpoint waits for, the words for it, and how many letters of its name may be wrong. A
#: server may start long after its client: /local_costmap is no mistake for /global_costmap.
_PARTNERS = {
    EntityKind.SUBSCRIPTION: (EntityKind.PUBLISHER, "publishes", "publisher", 2),
    EntityKind.CLIENT: (EntityKind.SERVICE, "offers", "server", 1),
}
_PAIRS = tuple({kind, partner} for kind, (partner, *_) in _PARTNERS.items())

_of_contexts: dict[Context, Diagnostics] = {}
_lock = threading.Lock()


def _leave_to_parent() -> None:
    global _lock  # noqa: PLW0603 - there is one per process
    fork.keep(dict(_of_contexts))
    _lock = threading.Lock()
    _of_contexts.clear()


fork.in_child.append(_leave_to_parent)


@dataclass(frozen=True, slots=True)
class GivenParameters:
    """Values of parameters that a node is given, and what their check needs of the node."""

    store: ParameterStore  #: the node's parameters
    on_command_line: set[str]  #: the names on the command line. A file may have more.
    logger_name: str
    was_spun: Callable[[], bool]  #: returns whether an executor has had the node


def diagnostics_of(context: Context) -> Diagnostics:
    """Return the diagnostics of a context. The first call starts them."""
    with _lock:
        diagnostics = _of_contexts.get(context)
        if diagnostics is None:
            diagnostics = _of_contexts[context] = Diagnostics(context)
        return diagnostics


class Diagnostics:
    """Compares a context's nodes and endpoints with all others, and logs likely mistakes.

    Args:
        context: The context whose nodes and endpoints are checked.
    """

    def __init__(self, context: Context) -> None:
        self._context = context
        self._own: dict[str, tuple[Token, str]] = {}
        self._news: deque[Token] = deque()
        # By delay, so that the first check of each queue is due first.
        self._checks: dict[float, deque[tuple[Deadline, object, Callable[[], None]]]] = {}
        self._planned: set[object] = set()  # what these checks are about
        self._known = Snapshot(())  # the graph during the present checks
        self._names: dict[tuple[EntityKind, str, str], KnownNames] = {}  # its partners' names
        self._equal: Counter[tuple[object, ...]] = Counter()  # own endpoints by node, kind, name
        self._silent: dict[str, tuple[EndpointToken, str]] = {}  # own endpoints without a partner
        self._warned: set[tuple[str, ...]] = set()
        self._stores: WeakSet[ParameterStore] = WeakSet()
        self._lock = threading.Lock()
        self._work = OnDemandThread(partial(context.start_thread, "zbot diagnostics"), self._turn)
        context.graph.add_listener(self._on_change)
        context.add_waker(self._work.wake)

    def add(self, token: Token, logger_name: str) -> None:
        """Check a node or endpoint from now on. Warnings are logged under `logger_name`."""
        if _is_standard(token):
            return
        with self._lock:
            self._own[token.key] = (token, logger_name)
        if isinstance(token, EndpointToken):
            self._count(token, logger_name)
            if token.kind in _PARTNERS:
                self._check_later(token.key, partial(self._check_silence, token, logger_name))
        if token.kind is not EntityKind.CLIENT or self._context.dialect.needs_equal_types:
            self._context.graph.follow(token)
            self._news.append(token)
        self._work.wake()

    def add_parameters(self, given: GivenParameters) -> None:
        """Warn later if a node does not declare parameters that it is given."""
        store = given.store
        self._stores.add(store)
        if store.overrides and not store.allow_undeclared:
            self._check_parameters_later(given, Deadline(_LONGEST_INIT_S))
            self._work.wake()

    def _check_parameters_later(self, given: GivenParameters, longest: Deadline) -> None:
        self._check_later(given.store, partial(self._check_parameters, given, longest))

    def _count(self, token: EndpointToken, logger_name: str) -> None:
        equality = _equality(token)
        with self._lock:
            self._equal[equality] += 1
            count = self._equal[equality]
        if count == MOST_EQUAL:
            self.warn_of_many(logger_name, f"{_KINDS[token.kind]} {token.name}")

    def warn_of_many(self, logger_name: str, what: str) -> None:
        """Warn that a node has `MOST_EQUAL` equal entities, if a program has made the last one."""
        line = calling_line()
        if line:
            text = f"{line}: this node now has {MOST_EQUAL} {what}: create one in __init__"
            self._warn(logger_name, ("many", what), f"{text}, and keep it")

    def warn_later(
        self,
        logger_name: str,
        about: tuple[str, ...],
        text_of: Callable[[], str],
        delay_s: float | None = None,
    ) -> None:
        """Warn of a mistake of a node later, if there is one then.

        Args:
            logger_name: The name of the node's logger.
            about: What the mistake is about. The logger gets one warning about it.
            text_of: Returns the warning, or an empty text. The diagnostics' thread calls it.
            delay_s: Seconds. The default is that of the other checks.
        """

        def check() -> None:
            if text := text_of():
                self._warn(logger_name, about, text)

        self._check_later((logger_name, *about), check, delay_s)
        self._work.wake()

    def remove(self, token: Token) -> None:
        """Stop checking a node or endpoint."""
        with self._lock:
            if self._own.pop(token.key, None) and isinstance(token, EndpointToken):
                equality = _equality(token)
                self._equal[equality] -= 1
                if not self._equal[equality]:
                    del self._equal[equality]
        self._silent.pop(token.key, None)

    def _check_later(
        self, about: object, check: Callable[[], None], delay_s: float | None = None
    ) -> None:
        """Make a check later. If a check about the same is planned, do nothing."""
        if about not in self._planned:
            self._planned.add(about)
            delay_s = _CHECK_DELAY_S if delay_s is None else delay_s
            self._checks.setdefault(delay_s, deque()).append((Deadline(delay_s), about, check))

    def _on_change(self, token: Token, appeared: bool) -> None:
        # The graph's thread runs this, so the comparison must not run here.
        if appeared:
            self._news.append(token)
            self._work.wake()

    def _turn(self) -> float | None:
        """Compare new tokens, and make the checks that are due."""
        if not self._context.is_running:
            with _lock:
                _of_contexts.pop(self._context, None)  # an entry would keep the context alive
            return None
        news = [self._news.popleft() for _ in range(len(self._news))]
        try:
            self._compare(news)
            self._make_checks()
        except (zenoh.ZError, NotInitializedError):
            if self._context.is_running:
                raise
            return 0.0  # the session was closed meanwhile
        first = [checks[0][0] for checks in list(self._checks.values()) if checks]
        return min((deadline.left_s for deadline in first), default=None)

    def _make_checks(self) -> None:
        due = [checks for checks in list(self._checks.values()) if checks and checks[0][0].is_over]
        if due:
            self._known, self._names = Snapshot(self._context.graph.known()), {}
        for checks in due:
            while checks and checks[0][0].is_over:
                _, about, check = checks.popleft()
                self._planned.discard(about)
                check()
        # They would keep the tokens of the whole graph.
        self._known, self._names = Snapshot(()), {}

    def _compare(self, news: list[Token]) -> None:
        with self._lock:
            own = dict(self._own)
        new = [own[token.key] for token in news if token.key in own]
        self._check_stopped(
            {_full_name(token): name for token, name in new if isinstance(token, NodeToken)}
        )
        self._check_silent_again(news)
        # Only tokens with one name are compared: a bridge may have thousands of topics.
        mine = _by_name(token for token, _ in own.values())
        for token in news:
            for one in mine.get(_full_name(token), ()):
                self._compare_pair(one, token, own[one.key][1])
        others = _by_name(self._context.graph.known() if new else ())
        for token, logger_name in new:
            self._check_shared(token, logger_name)
            for other in others.get(_full_name(token), ()):
                self._compare_pair(token, other, logger_name)

    def _check_shared(self, token: Token, logger_name: str) -> None:
        """Warn that others get a student's messages below /class/ only if the teacher allows it."""
        is_speaking = token.kind in {EntityKind.PUBLISHER, EntityKind.SERVICE}
        if self._context.is_student and is_speaking and token.domain == SHARED_DOMAIN:
            self._warn(
                logger_name,
                ("shared",),
                "others receive what this node sends in /class/ only after the teacher "
                "allowed it with: zbot share class",
            )

    def _compare_pair(self, mine: Token, other: Token, logger_name: str) -> None:
        """Compare two tokens of one name."""
        if mine.key == other.key:
            return
        if isinstance(mine, NodeToken) and isinstance(other, NodeToken):
            self._warn_of_namesake(mine, logger_name)
        elif isinstance(mine, EndpointToken) and isinstance(other, EndpointToken):
            self._compare_types(mine, other, logger_name)

    def _warn_of_namesake(self, mine: NodeToken, logger_name: str) -> None:
        name = _full_name(mine)
        self._warn(
            logger_name,
            ("node", name),
            f"there is another node named {name}; give one of them another name: "
            f"--ros-args -r __node:={mine.node}_2",
        )

    def _check_stopped(self, nodes: dict[str, str]) -> None:
        """Warn if a program that Ctrl-Z has stopped has a node of the same name.

        A stopped program does not answer, so the graph may not show its nodes.

        Args:
            nodes: The full names of own nodes, each with the name of its logger.
        """
        if not nodes:
            return
        programs = running_programs.stopped(self._context.get_domain_id(), nodes.keys())
        for name, logger_name in nodes.items():
            text = running_programs.stopped_text([p for p in programs if name in p.nodes])
            if text:
                self._warn(logger_name, ("stopped", name), f"another node has this name: {text}")

    def _compare_types(self, mine: EndpointToken, other: EndpointToken, logger_name: str) -> None:
        if self._context.dialect.needs_equal_types and {mine.kind, other.kind} in _PAIRS:
            self._compare_definitions(mine, other, logger_name)
        if mine.kind not in _VERBS or other.kind not in _VERBS:
            return
        if mine.type_name == other.type_name:
            return
        who = other.full_node_name
        self._warn(
            logger_name,
            ("type", mine.name, mine.type_name, other.type_name),
            f"{mine.name} has two types: this node uses {mine.type_name}, but {who} "
            f"{_VERBS[other.kind]} {other.type_name}; they cannot receive each other's messages",
        )

    def _compare_definitions(
        self, mine: EndpointToken, other: EndpointToken, logger_name: str
    ) -> None:
        if mine.type_name != other.type_name or mine.type_hash == other.type_hash:
            return
        about = ("definition", mine.name, mine.type_hash, other.type_hash)
        if (logger_name, *about) not in self._warned:
            from zbot.node.type_difference import difference_text  # noqa: PLC0415 - rarely needed

            self._warn(logger_name, about, difference_text(self._context, mine, other))

    def _check_silence(self, token: EndpointToken, logger_name: str) -> None:
        """If an endpoint has no partner, learn the names of all partners of its type."""
        if not self._is_silent(token) or self._warn_of_unreachable(token, logger_name):
            return
        self._silent[token.key] = (token, logger_name)
        self._context.graph.follow_type(token.domain, _PARTNERS[token.kind][0], token.type_name)
        self._check_later(token.key, partial(self._check_name, token, logger_name), _HISTORY_S)

    def _check_silent_again(self, news: list[Token]) -> None:
        """If an endpoint waits for a partner of a new type, check later whether it has come."""
        came = {(token.kind, token.type_name) for token in news if isinstance(token, EndpointToken)}
        for token, logger_name in list(self._silent.values()):
            if (_PARTNERS[token.kind][0], token.type_name) in came:
                self._check_later(token.key, partial(self._check_name, token, logger_name))

    def _is_silent(self, token: EndpointToken) -> bool:
        # A node of a command has a hidden name, which contains `/_` or begins with `_`. It needs no
        # warning here, because the command itself reports a topic without a publisher.
        name = token.name.removesuffix(_ending(token))
        if token.key not in self._own or is_hidden(name) or is_hidden(token.node):
            return False
        return not self._known.on(token.name, _PARTNERS[token.kind][0])

    def _check_name(self, token: EndpointToken, logger_name: str) -> None:
        """Warn if an endpoint without a partner may have a misspelt name."""
        if not self._is_silent(token):
            self._silent.pop(token.key, None)
            return
        _, verb, partner, most_edits = _PARTNERS[token.kind]
        name = token.name.removesuffix(_ending(token))
        guess = self._partner_names(token).nearest(name, most_edits)
        if guess is not None:
            type_name = token.type_name.removesuffix("_SendGoal")
            self._warn(
                logger_name,
                ("typo", name, guess),
                f"nobody {verb} {name}, but {guess} ({type_name}) has a {partner}: "
                "is one of the names misspelt?",
            )

    def _partner_names(self, token: EndpointToken) -> KnownNames:
        """Return the names of all possible partners of an endpoint during the present checks."""
        kind, type_name, ending = about = _PARTNERS[token.kind][0], token.type_name, _ending(token)
        if about not in self._names:
            ends = [end for end in self._known.of_kind(kind) if end.type_name == type_name]
            self._names[about] = KnownNames(
                {end.name.removesuffix(ending) for end in ends if end.name.endswith(ending)}
            )
        return self._names[about]

    def _check_parameters(self, given: GivenParameters, longest: Deadline) -> None:
        store = given.store
        if store.may_grow:
            return
        own = sorted(name for name in list(store.values) if name not in _STANDARD_PARAMETERS)
        if not (own or given.was_spun() or longest.is_over):
            self._check_parameters_later(given, longest)
            return
        # A value without the name of a node may be meant for another node of the program.
        known = {name for other in self._stores for name in list(other.values)}
        listed = f"it declares {', '.join(own)}" if own else "it declares none"
        for name in sorted(given.on_command_line - known):
            advice = did_you_mean(name, own) or listed
            self._warn_of_parameter(given.logger_name, name, "of the command line", advice)
        # A file may be for several nodes, so most names that this node lacks are no mistakes.
        free = [name for name in own if name not in store.overrides]
        for name in sorted(store.overrides.keys() - given.on_command_line - known):
            guess = nearest(name, free)
            if guess is not None:
                advice = question([guess])
                self._warn_of_parameter(given.logger_name, name, "that it was given", advice)

    def _warn_of_parameter(self, logger_name: str, name: str, origin: str, advice: str) -> None:
        self._warn(
            logger_name,
            ("parameter", name),
            f"this node does not declare the parameter {name} {origin}; {advice}",
        )

    def _warn_of_unreachable(self, token: EndpointToken, logger_name: str) -> bool:
        """Warn if a publisher's messages can reach the router, but not this program.

        Returns:
            Whether the topic has such a publisher.
        """
        if token.kind is not EntityKind.SUBSCRIPTION:
            return False
        unreachable = Snapshot(tuple(self._context.unreachable_tokens()))
        publishers = unreachable.publishers(token.name)
        for publisher in publishers[:1]:
            who = publisher.full_node_name
            self._warn(
                logger_name,
                ("link", token.name),
                f"nothing is heard from {who} on {token.name}, because there is no way from it "
                "to this program, and routers of ROS 2 pass nothing on between two peers: set "
                "ZENOH_CONFIG_OVERRIDE='mode=\"client\"' for this program",
            )
        return bool(publishers)

    def _warn(self, logger_name: str, about: tuple[str, ...], text: str) -> None:
        if (logger_name, *about) not in self._warned:
            self._warned.add((logger_name, *about))
            get_logger(logger_name).warning(text)


def _is_standard(token: Token) -> bool:
    """Return whether this is a publisher of every node, e.g. of /rosout. It needs no check."""
    if not isinstance(token, EndpointToken) or token.kind is not EntityKind.PUBLISHER:
        return False
    return token.type_name == _STANDARD_TYPES.get(token.name)


def _full_name(token: Token) -> str:
    """Return the full name of a node, or the name of an endpoint's topic or service."""
    return token.full_node_name if isinstance(token, NodeToken) else token.name


def _by_name(tokens: Iterable[Token]) -> dict[str, list[Token]]:
    found: dict[str, list[Token]] = {}
    for token in tokens:
        found.setdefault(_full_name(token), []).append(token)
    return found


def _equality(token: EndpointToken) -> tuple[object, ...]:
    return token.namespace, token.node, token.kind, token.name


def _ending(token: EndpointToken) -> str:
    """Return the part of a name that users do not write: an action has a service for its goals."""
    return SEND_GOAL if token.name.endswith(SEND_GOAL) else ""
