"""`zbot topic echo`: prints the messages of one topic or several."""

from __future__ import annotations

import sys
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING, Any

from zbot.executor.single_threaded_executor import SingleThreadedExecutor
from zbot.node.event_callbacks import SubscriptionEventCallbacks
from zbot.text.terminal import write_styled
from zbot.threads.deadline import Deadline
from zbot.wire.tokens import EndpointToken, EntityKind
from zbot_cli.commands.topic.problems import TopicProblems
from zbot_cli.domain.client import full_name, hidden_node
from zbot_cli.domain.kinds import TOPIC
from zbot_cli.domain.waiting import hint_if_silent, print_waiting
from zbot_cli.errors import CommandError
from zbot_cli.input.domain_names import as_typed

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.graph.snapshot import Token
    from zbot.node.message_info import MessageInfo
    from zbot.node.node import Node
    from zbot.node.qos_events import QoSMessageLostInfo
    from zbot_cli.input.filter import Filter
    from zbot_cli.input.qos_options import QosOptions
    from zbot_cli.output.message_text import Form

_CLEAR = "\033[H\033[2J"


class Echo:
    """Printer of messages. It ends at Ctrl-C, or earlier with `once` or `timeout_s`.

    Args:
        words: Topics, possibly with wildcards, and optionally a type after the last topic.
        form: How to show messages.
        qos: Quality of service options.
        once: End after the first message that is printed.
        timeout_s: End after this many seconds. It is an error if no message was printed by then.
        node_name: The name of the subscribing node. None means a hidden name.
        use_sim_time: Whether the node follows `/clock`.
    """

    def __init__(
        self,
        words: Sequence[str],
        form: Form,
        qos: QosOptions,
        *,
        once: bool,
        timeout_s: float | None,
        node_name: str | None,
        use_sim_time: bool,
    ) -> None:
        self._names, self._type = _split(list(words))
        self._qos = qos
        self._once = once
        self._timeout_s = timeout_s
        self._node_name = node_name
        self._use_sim_time = use_sim_time
        self._form = form
        self._problems = TopicProblems(self._names)
        self._subscribed: set[str] = set()
        self._shown = 0
        self._done = False

    @property
    def _several(self) -> bool:
        return len(self._names) > 1 or any(map(_is_pattern, self._names))

    def run(self) -> None:
        """Print messages until the end. Leave out what only fits a pattern and cannot be printed.

        Raises:
            CommandError: The time limit passed without a message, or a topic that the command line
                names cannot be printed.
        """
        from zbot_cli.output.message_text import Formatter  # noqa: PLC0415 - only echo formats messages

        self._format = Formatter(self._form, with_topic=self._several)
        self._filter = _filter(self._form)
        with hidden_node("echo", self._node_name, use_sim_time=self._use_sim_time) as node:
            executor = SingleThreadedExecutor(context=node.context)
            executor.add_node(node)
            hint_if_silent(node, self._start(node), lambda: not self._shown)
            self._spin(executor, Deadline(self._timeout_s))
        if self._timeout_s is not None and not self._shown:
            names = ", ".join(map(as_typed, self._names))
            raise CommandError(f"no message on {names} within {self._timeout_s:g} s")

    def _start(self, node: Node) -> list[str]:
        """Subscribe to the topics that exist. Return the topics without a printed similar name."""
        unexplained: list[str] = []
        graph = node.context.graph
        snapshot = graph.snapshot()
        for name in self._names:
            type_name = None if _is_pattern(name) else self._type or TOPIC.only_type(snapshot, name)
            if type_name is not None:
                self._subscribe(node, name, type_name)
            if not _is_pattern(name) and (type_name or not print_waiting(TOPIC, snapshot, name)):
                unexplained.append(name)
        if self._subscribed != set(self._names):
            self._node = node
            graph.watch()
            graph.add_listener(self._on_change)
        return unexplained

    def _on_change(self, token: Token, appeared: bool) -> None:
        # Zenoh's thread calls this method. Creating a subscription in this thread could deadlock.
        if (
            not appeared
            or not isinstance(token, EndpointToken)
            or token.kind is not EntityKind.PUBLISHER
        ):
            return
        if token.name not in self._subscribed and any(
            fnmatchcase(token.name, name.replace("**", "*")) for name in self._names
        ):
            self._node.executor.create_task(  # type: ignore[union-attr]
                self._subscribe_new, self._node, token.name, token.type_name
            )

    def _subscribe_new(self, node: Node, name: str, type_name: str) -> None:
        # Two publishers may have come at the same time.
        if name not in self._subscribed and name not in self._problems.topics:
            with self._problems.of(name):
                self._subscribe(node, name, type_name)

    def _subscribe(self, node: Node, name: str, type_name: str) -> None:
        message_type = TOPIC.class_of(type_name)
        self._format.check(message_type)
        if self._filter is not None:
            self._filter.check(message_type, self._format.subject)
        self._subscribed.add(name)
        qos = self._qos.to_subscribe(node.context.graph.snapshot().publishers(name))
        callbacks = SubscriptionEventCallbacks(message_lost=self._on_lost)
        node.create_subscription(
            message_type,
            name,
            lambda message, info: self._show(name, message, info),
            qos,
            raw="payload" if self._form.raw else False,
            event_callbacks=callbacks,
        )

    def _spin(self, executor: SingleThreadedExecutor, deadline: Deadline) -> None:
        while executor.context.ok() and not self._done and not deadline.is_over:
            executor.spin_once(deadline.left_s)

    def _show(self, name: str, message: Any, info: MessageInfo) -> None:
        text = None
        with self._problems.of(name):
            if not self._done and self._is_wanted(message):
                text = self._format.text(name, message, info)
        if text is None:
            return
        if self._form.clear:
            write_styled(sys.stdout, _CLEAR)
        sys.stdout.write(text)
        sys.stdout.flush()
        self._shown += 1
        self._done = self._once

    def _is_wanted(self, message: Any) -> bool:
        return self._filter is None or self._filter.accepts(self._format.subject(message))

    def _on_lost(self, info: QoSMessageLostInfo) -> None:
        if self._form.losses:
            print(
                f"A message was lost!!!\n\ttotal count change:{info.total_count_change}\n"
                f"\ttotal count: {info.total_count}\n---",
                flush=True,
                file=sys.stderr if self._form.json else sys.stdout,
            )


def _filter(form: Form) -> Filter | None:
    if form.filter_expression is None:
        return None
    from zbot_cli.input.filter import Filter  # noqa: PLC0415 - seldom used

    return Filter(form.filter_expression)


def _split(words: list[str]) -> tuple[list[str], str | None]:
    """Return the topics and the type.

    The last word is the type if it contains `/` or `.`, and does not begin with `/`.
    """
    last = words[-1]
    is_topic = len(words) == 1 or last.startswith("/") or "*" in last
    has_type = not is_topic and ("/" in last or "." in last)
    if has_type:
        return list(map(full_name, words[:-1])), TOPIC.resolve_type(last)
    return list(map(full_name, words)), None


def _is_pattern(name: str) -> bool:
    return "*" in name
