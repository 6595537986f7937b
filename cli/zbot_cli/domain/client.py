"""Zenoh session of a command. It is a client of the domain's router."""

from __future__ import annotations

import contextlib
import functools
import os
import re
import signal
import sys
from typing import TYPE_CHECKING

from zbot.context import Context
from zbot.errors import ExternalShutdownException
from zbot.graph.snapshot import Snapshot
from zbot.names import is_hidden
from zbot.text.terminal import escape_control_characters
from zbot.transport import running_programs
from zbot.transport.config import DiscoveryRange, discovery_range, domain_id
from zbot_cli.errors import CommandError
from zbot_cli.output.exit_status import Status

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.node.node import Node
# The name of a topic may look so too. Such a topic is named with its leading slash.
_TYPE = re.compile(r"\w+/(msg|srv|action)/[A-Z]\w*", re.ASCII)


@contextlib.contextmanager
def client(*, wait: bool = False) -> Iterator[Context]:
    """Yield a context in the domain. Its session is closed at the end of the `with` block.

    Args:
        wait: Keep the session open even if no node is running, so that later nodes are found.
    """
    if discovery_range() is DiscoveryRange.OFF:
        print(
            "discovery is switched off (ZBOT_DISCOVERY_RANGE=OFF): no node can be seen",
            file=sys.stderr,
        )
    print_programs_outside()
    _print_other_versions()
    context = Context(mode="client")
    context.init([])
    try:
        context.connect(wait=wait)
        yield context
    finally:
        context.shutdown()


def print_programs_outside() -> None:
    """Print the nodes of this machine that are not in the class or hub that it has joined."""
    text = running_programs.outside_text()
    if text:
        print(escape_control_characters(text), file=sys.stderr)


@functools.cache
def _print_other_versions() -> None:
    """Print once the programs of this machine and domain that have another version of zbot."""
    text = running_programs.versions_text(domain_id())
    if text:
        print(escape_control_characters(text), file=sys.stderr)


def snapshot_of(context: Context) -> Snapshot:
    """Return the graph. It is empty if no node is running."""
    return Snapshot(()) if context.is_closed else context.graph.snapshot()


def snapshot() -> Snapshot:
    """Return the graph of the domain at this moment."""
    with client() as context:
        return snapshot_of(context)


def note_if_nobody_runs(graph: Snapshot) -> None:
    """If no node is running, print this on stderr. Print nothing if stderr is not a terminal."""
    if sys.stderr.isatty() and has_nobody(graph):
        print(f"no node is running in domain {domain_id()}; {_where_to_look()}", file=sys.stderr)


def has_nobody(graph: Snapshot) -> bool:
    """Return whether no node is running, except for the nodes of commands."""
    return all(is_hidden(node.node) for node in graph.nodes)


def nobody_runs() -> str:
    """Return a sentence which says that no node is running, and where this machine's nodes are."""
    elsewhere = running_programs.elsewhere_text(domain_id())
    return f"no node is running{f' in domain {domain_id()}; {elsewhere}' if elsewhere else ''}"


def _where_to_look() -> str:
    return escape_control_characters(running_programs.elsewhere_text(domain_id())) or (
        "start one in another terminal, e.g. zbot run sensor"
    )


def print_stopped_programs() -> None:
    """Print on stderr which programs of the domain are stopped (Ctrl-Z), if any."""
    text = running_programs.stopped_text(running_programs.stopped(domain_id()))
    if text:
        print(escape_control_characters(text), file=sys.stderr, flush=True)


@contextlib.contextmanager
def hidden_node(
    verb: str, name: str | None = None, *, use_sim_time: bool = False, survives_ctrl_c: bool = False
) -> Iterator[Node]:
    """Yield a node for a command that publishes or subscribes.

    Args:
        verb: Verb of the command. It is part of the hidden name.
        name: A visible name, or `None` for a hidden name.
        use_sim_time: Whether the node follows `/clock`.
        survives_ctrl_c: Whether the node stays open at Ctrl-C, so that the command can clean up.
    """
    from zbot.node.node import Node  # noqa: PLC0415 - not needed by `list`
    from zbot.process.signals import SignalHandlerOptions, install, last_signal  # noqa: PLC0415 - not needed by `list`

    options = SignalHandlerOptions.SIGTERM if survives_ctrl_c else SignalHandlerOptions.ALL
    install(options, calls_ok=False)  # nobody calls `ok()` while the session opens
    with client(wait=True) as context:
        install(options)
        node = Node(
            name or f"_zbot_cli_{verb}_{os.getpid()}",
            context=context,
            cli_args=["--ros-args", "-p", "use_sim_time:=true"] if use_sim_time else None,
            enable_rosout=False,
            start_parameter_services=False,
        )
        try:
            yield node
            is_terminated = context.is_interrupted and last_signal() == signal.SIGTERM
        except ExternalShutdownException:
            is_terminated = True
        finally:
            node.destroy_node()
        if is_terminated:
            sys.exit(Status.TERMINATED)


def full_name(name: str) -> str:
    """Return a topic, service or node name with its leading slash.

    Raises:
        CommandError: The name is the name of a type.
    """
    if _TYPE.fullmatch(name):
        raise CommandError(
            f"{name} is a type, not a name", hint=f"write the name before it: /NAME {name}"
        )
    return name if name.startswith("/") else f"/{name}"
