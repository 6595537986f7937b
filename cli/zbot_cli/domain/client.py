"""How a command looks at the domain: as a client of its meeting point, for as long as it takes."""

from __future__ import annotations

import contextlib
import os
import sys
from typing import TYPE_CHECKING

from zbot.context import Context
from zbot.errors import ExternalShutdownException
from zbot.graph.snapshot import Snapshot
from zbot.transport.config import DiscoveryRange, discovery_range
from zbot_cli.output.exit_status import Status

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.node.node import Node


@contextlib.contextmanager
def client(*, wait: bool = False) -> Iterator[Context]:
    """Yield a context that sees the domain; its session is closed at the end.

    Args:
        wait: Stay even if nobody is there yet, so that nodes which come later are seen.
    """
    if discovery_range() is DiscoveryRange.OFF:
        print(
            "discovery is switched off (ZBOT_DISCOVERY_RANGE=OFF): no node can be seen",
            file=sys.stderr,
        )
    context = Context(mode="client")
    context.init([])
    try:
        context.connect(wait=wait)
        yield context
    finally:
        context.shutdown()


def snapshot_of(context: Context) -> Snapshot:
    """Return the graph, empty if nobody is there."""
    return Snapshot(()) if context.is_closed else context.graph.snapshot()


def snapshot() -> Snapshot:
    """Look once."""
    with client() as context:
        return snapshot_of(context)


@contextlib.contextmanager
def hidden_node(
    verb: str, name: str | None = None, *, use_sim_time: bool = False, survives_ctrl_c: bool = False
) -> Iterator[Node]:
    """Yield a node for a command that publishes or listens; hidden unless it is given a name.

    Args:
        verb: What the command does; part of the hidden name.
        name: A visible name.
        use_sim_time: Whether the node follows `/clock`.
        survives_ctrl_c: Whether Ctrl-C leaves it open, for a command that has to tidy up.
    """
    from zbot.node.node import Node  # noqa: PLC0415 - lists do without
    from zbot.process.signals import SignalHandlerOptions, install  # noqa: PLC0415 - lists do without

    install(SignalHandlerOptions.SIGTERM if survives_ctrl_c else SignalHandlerOptions.ALL)
    with client(wait=True) as context:
        node = Node(
            name or f"_zbot_cli_{verb}_{os.getpid()}",
            context=context,
            cli_args=["--ros-args", "-p", "use_sim_time:=true"] if use_sim_time else None,
            enable_rosout=False,
            start_parameter_services=False,
        )
        try:
            yield node
        except ExternalShutdownException:
            sys.exit(Status.TERMINATED)
        finally:
            node.destroy_node()


def full_name(name: str) -> str:
    """Return a topic, service or node name with its leading slash."""
    return name if name.startswith("/") else f"/{name}"
