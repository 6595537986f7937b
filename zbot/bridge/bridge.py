"""Bridge that runs until Ctrl-C. It has a zbot node, two sides and a route manager."""

from __future__ import annotations

import json
import os
import secrets
import threading
import time
from collections.abc import Callable
from contextlib import ExitStack, suppress
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Protocol

from zbot.bridge.rclpy_import import import_rclpy
from zbot.bridge.rclpy_side import RclpySide
from zbot.bridge.route_manager import RouteManager
from zbot.bridge.selection import Selection
from zbot.bridge.side import NODE_PREFIX
from zbot.bridge.zbot_side import ZbotSide
from zbot.context import Context
from zbot.errors import ExternalShutdownException
from zbot.executor.single_threaded_executor import SingleThreadedExecutor
from zbot.executor.spin_thread import SpinThread
from zbot.node.node import Node
from zbot.process.signals import SignalHandlerOptions, install
from zbot.transport.rmw_choice import RMW_ZENOH
from zbot.wire.dialect import ZBOT_IDENTIFIER

if TYPE_CHECKING:
    from zbot.bridge.side import Side


# The graph of zbot is complete immediately. DDS usually needs a second to find another bridge.
_DISCOVERY_S = 3.0
# ROS 2's variable with changes to the configuration of rmw_zenoh.
_OVERRIDE = "ZENOH_CONFIG_OVERRIDE"


class PublisherFilter(Protocol):
    """Decides which messages and requests pass from zbot to ROS 2."""

    def start(self) -> None:
        """Begin to decide."""
        ...

    def admits(self, name: str, gid: bytes) -> bool:
        """Return whether a message or a request may pass.

        Args:
            name: Name of the topic or service.
            gid: Id of the publisher or client.
        """
        ...

    def close(self) -> None:
        """End the work of the filter."""
        ...


#: Makes a filter. The arguments are the bridge's context, a function that stops the robot, and a
#: function that ends the bridge.
MakeFilter = Callable[[Context, Callable[[], None], Callable[[], None]], PublisherFilter]


@dataclass(frozen=True)
class BridgeOptions:
    """What a bridge is asked to do."""

    ros_domain: int = 0  #: domain of ROS 2, 0 to 232
    connect: str = ""  #: address of rmw_zenoh's router; by default, the router of this machine
    prefix: str = ""  #: namespace in zbot for all names of ROS 2, e.g. `/robot1`
    selection: Selection = field(default_factory=Selection)
    make_filter: MakeFilter | None = None  #: `None`: everything passes
    on_ready: Callable[[], None] = lambda: None  #: called when the bridge works


def new_bridge_id() -> str:
    """Return an id. A bridge that starts later has a greater id, if the machines' clocks agree."""
    return f"{time.time_ns() // 1_000_000:011x}{secrets.token_hex(2)}"


def run_dds(options: BridgeOptions) -> None:
    """Link the zbot domain of this process and DDS, until Ctrl-C or SIGTERM.

    Raises:
        BridgeError: This Python cannot import a genuine rclpy.
    """
    import_rclpy()  # before a session is opened
    install(SignalHandlerOptions.ALL)
    bridge_id = new_bridge_id()
    with ExitStack() as stack:
        node = _node(bridge_id, ZBOT_IDENTIFIER, None, stack)
        failure = _Failure(node.context)
        ros = RclpySide(bridge_id, options.ros_domain, node.get_logger(), failure.note)
        stack.callback(ros.close)
        _carry(options, node, ros, stack, failure)


def run_rmw_zenoh(options: BridgeOptions) -> None:
    """Link the zbot domain of this process and rmw_zenoh, until Ctrl-C or SIGTERM.

    Raises:
        NoRouterError: The router of ROS 2 is on another machine and does not answer.
        SettingError: The address of the router is not valid.
    """
    if options.connect:
        given = os.environ.get(_OVERRIDE, "").rstrip(";")
        # A `;` in the address is escaped, because `;` separates the settings in the variable.
        address = json.dumps(options.connect).replace(";", r"\u003b")
        wanted = f"connect/endpoints=[{address}]"
        os.environ[_OVERRIDE] = ";".join(filter(None, (given, wanted)))
    install(SignalHandlerOptions.ALL)
    bridge_id = new_bridge_id()
    with ExitStack() as stack:
        node = _node(bridge_id, ZBOT_IDENTIFIER, None, stack)
        foreign = _node(bridge_id, RMW_ZENOH, options.ros_domain, stack)
        ros = ZbotSide(foreign, label="ROS 2", wire_format="cdr")
        stack.callback(ros.close)
        failure = _Failure(node.context)
        spinner = SpinThread(foreign, "zbot bridge ROS 2", failure.note)
        stack.callback(spinner.stop, 5)
        _carry(options, node, ros, stack, failure)


def _node(bridge_id: str, rmw: str, domain: int | None, stack: ExitStack) -> Node:
    """Return a node of the bridge in a context of its own. The exit stack destroys both."""
    context = Context(rmw=rmw)
    context.init(domain_id=domain)
    stack.callback(context.shutdown)
    node = Node(NODE_PREFIX + bridge_id, context=context, enable_rosout=False)
    stack.callback(node.destroy_node)
    return node


class _Failure:
    """Unexpected exception of another thread, which ends the bridge.

    Args:
        context: The context that the main thread spins.
    """

    def __init__(self, context: Context) -> None:
        self._context = context
        self._error: Exception | None = None

    def note(self, error: Exception) -> None:
        """Let the main thread raise an exception."""
        self._error = self._error or error
        self._context.interrupt()

    def raise_if_any(self) -> None:
        """Raise the exception, if there is one."""
        if self._error is not None:
            raise self._error


def _carry(
    options: BridgeOptions, node: Node, ros: Side, stack: ExitStack, failure: _Failure
) -> None:
    """Link the domain of `node` and the side `ros`, until the node's context is interrupted."""
    context, log = node.context, node.get_logger()
    publisher_filter: PublisherFilter | None = None
    if options.make_filter is not None:

        def halt() -> None:
            manager.halt()

        publisher_filter = options.make_filter(context, halt, context.interrupt)
    zbot = ZbotSide(node, admits=None if publisher_filter is None else publisher_filter.admits)
    stack.callback(zbot.close)
    manager = RouteManager(
        zbot,
        ros,
        options.selection,
        bridge_id=node.get_name().removeprefix(NODE_PREFIX),
        prefix=options.prefix,
        log=log,
        patience_s=_DISCOVERY_S,
    )

    def carry() -> None:
        try:
            manager.run()
        except Exception as error:  # noqa: BLE001 - the main thread raises it
            failure.note(error)

    thread = threading.Thread(target=carry, name="zbot bridge", daemon=True)
    thread.start()
    stack.callback(thread.join)
    stack.callback(manager.close)
    if publisher_filter is not None:
        publisher_filter.start()
        stack.callback(publisher_filter.close)
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(node)
    log.info(
        f"carrying between zbot domain {context.get_domain_id()} "
        f"and {ros.label} domain {options.ros_domain} (Ctrl-C ends)"
    )
    options.on_ready()
    with suppress(KeyboardInterrupt, ExternalShutdownException):
        executor.spin()
    failure.raise_if_any()
