"""`zbot topic pub`: publishes messages from the command line or a file, at a rate."""

from __future__ import annotations

import sys
import time
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from zbot.threads.deadline import Deadline
from zbot.wire.tokens import EntityKind
from zbot_cli.domain.client import full_name, hidden_node, snapshot
from zbot_cli.domain.kinds import TOPIC
from zbot_cli.domain.waiting import HINT_DELAY_S, PeriodicSleep, print_missing
from zbot_cli.errors import CommandError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.node.node import Node
    from zbot.node.publisher import Publisher
    from zbot_cli.input.message_values import Template
    from zbot_cli.input.qos_options import QosOptions

#: The kind of a topic on which a command publishes: its errors name `pub`.
_TO_PUBLISH = replace(
    TOPIC,
    has_several="Cannot publish on topic '{name}', as it has more than one type: [{types}]",
    example="zbot topic pub {name} {type}",
)


def values_file_error(path: str, reason: str) -> CommandError:
    """Return the error that a file of values cannot be read, or contains no message."""
    return CommandError(f"cannot read {path}: {reason}")


@dataclass(frozen=True)
class Pace:
    """Rate of publishing, and conditions to start and end it."""

    rate_hz: float = 1.0
    print_every: int = 1
    times: int = 0  #: 0 means until Ctrl-C
    wait_for: int | None = None  #: subscriptions to wait for; `None`: 1 if `times` > 0, else 0
    max_wait_s: float | None = None
    keep_alive_s: float = 0.1

    @property
    def subscriptions(self) -> int:
        """Number of subscriptions to wait for."""
        return (1 if self.times else 0) if self.wait_for is None else self.wait_for

    def check(self) -> None:
        """Check that the values fit together.

        Raises:
            CommandError: The rate is not above 0, or `max_wait_s` is given, but there is nothing to
                wait for.
        """
        if not self.rate_hz > 0:
            raise CommandError("argument -r/--rate: Value must be positive")
        if self.max_wait_s is not None and not self.subscriptions:
            raise CommandError(
                "--max-wait-time-secs option is only effective with --wait-matching-subscriptions, "
                "--once or --times"
            )


class Pub:
    """Publisher that ends at Ctrl-C, after a number of messages, or at the end of a file.

    Args:
        topic: The topic's name.
        words: A type and values. The type may be left out if a node uses the topic.
        pace: Rate of publishing, and conditions to start and end it.
        qos: Quality of service options.
        node_name: A visible name for the publishing node.
        stdin: Read the values from standard input.
        yaml_file: Publish each document of a file.
        use_sim_time: Whether the node follows `/clock`.
    """

    def __init__(
        self,
        topic: str,
        words: Sequence[str],
        pace: Pace,
        qos: QosOptions,
        *,
        node_name: str | None,
        stdin: bool,
        yaml_file: str | None,
        use_sim_time: bool,
    ) -> None:
        self._topic = full_name(topic)
        self._words = list(words)
        self._pace = pace
        self._qos = qos
        self._node_name = node_name
        self._stdin = stdin
        self._yaml_file = yaml_file
        self._use_sim_time = use_sim_time

    def run(self) -> None:
        """Check the type and the values, wait for subscribers, and publish."""
        import zbot  # noqa: F401, PLC0415 - makes the message packages importable

        self._pace.check()
        type_name, values = self._type_and_values()
        message_type = TOPIC.class_of(type_name)
        templates = self._templates(message_type, values)
        with hidden_node("pub", self._node_name, use_sim_time=self._use_sim_time) as node:
            publisher = node.create_publisher(message_type, self._topic, self._qos.to_publish())
            self._wait(node, publisher)
            self._publish(node, publisher, templates)

    def _type_and_values(self) -> tuple[str, list[str]]:
        found, values = TOPIC.split(self._words)
        found = found or _TO_PUBLISH.only_type(snapshot(), self._topic)
        if found is None:
            raise CommandError(
                f"Could not determine the type of {self._topic}: no node uses it yet",
                hint=f"name the type: zbot topic pub {self._topic} "
                'std_msgs/msg/String "data: hello"',
            )
        return found, values

    def _templates(self, message_type: type[Any], values: list[str]) -> list[Template]:
        from zbot_cli.input.message_values import Template, split_documents  # noqa: PLC0415 - as in `run`

        if self._yaml_file is not None:
            documents = split_documents(read_values(self._yaml_file))
            if not documents:
                raise values_file_error(self._yaml_file, "there is no message in it")
            return [Template(message_type, document) for document in documents]
        return [Template(message_type, sys.stdin.read() if self._stdin else values)]

    def _wait(self, node: Node, publisher: Publisher[Any]) -> None:
        wanted = self._pace.subscriptions
        if not wanted:
            return
        deadline = Deadline(self._pace.max_wait_s)
        hint_time, is_hinted = Deadline(HINT_DELAY_S), False
        while node.context.ok() and publisher.get_subscription_count() < wanted:
            if hint_time.is_over and not is_hinted:
                print_missing(node.context.graph.snapshot(), self._topic, EntityKind.SUBSCRIPTION)
                is_hinted = True
            print(f"Waiting for at least {wanted} matching subscription(s)...", flush=True)
            node.context.graph.wait_for(
                lambda _: publisher.get_subscription_count() >= wanted, min(deadline.left_s, 1.0)
            )
            found = publisher.get_subscription_count()
            if found < wanted and deadline.is_over:
                raise CommandError(
                    f"Timed out waiting for subscribers: Expected {wanted} subscribers "
                    f"but only got {found} subscribers"
                )

    def _publish(self, node: Node, publisher: Publisher[Any], templates: list[Template]) -> None:
        now_ns = lambda: node.get_clock().now().nanoseconds  # noqa: E731 - one expression, twice used
        messages = [template.make(now_ns) for template in templates]
        limit = len(templates) if self._yaml_file is not None else self._pace.times
        print("publisher: beginning loop", flush=True)
        sleep, sent = PeriodicSleep(node.context, self._pace.rate_hz), 0
        while node.context.ok():
            index = sent % len(templates)
            if templates[index].is_stamped:
                messages[index] = templates[index].make(now_ns)
            publisher.publish(messages[index])
            sent += 1
            if self._pace.print_every and sent % self._pace.print_every == 0:
                print(f"publishing #{sent}: {messages[index]!r}\n", flush=True)
            if limit and sent >= limit:
                sleep.until(time.monotonic() + self._pace.keep_alive_s)
                return
            sleep.until_next()


def read_values(path: str) -> str:
    """Return the text of a file of values.

    Raises:
        CommandError: The file cannot be read.
    """
    try:
        return Path(path).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as exc:
        raise values_file_error(path, getattr(exc, "strerror", None) or str(exc)) from exc
