"""Access to the running system for all pages, through one hidden node in its own thread."""

from __future__ import annotations

import os
import threading
import traceback
from typing import TYPE_CHECKING, Any

from zbot.action import ActionClient
from zbot.context import Context
from zbot.errors import NotInitializedError, ZbotError
from zbot.executor.spin_thread import SpinThread
from zbot.interfaces import get_interface, get_message
from zbot.interfaces.registry import find_spec
from zbot.log import LoggingSeverity, get_logger, set_logger_level
from zbot.names import ROSOUT_TOPIC
from zbot.node.node import Node
from zbot.observer.errors import ViewerError
from zbot.observer.log_ring import LogRing
from zbot.observer.shared_entities import RepeatedPublishing, SharedEntities
from zbot.observer.watch import QUEUE_DEPTH, Feed, Watch, subscribe_to_payloads
from zbot.qos import qos_profile_rosout_default
from zbot.remote.parameters import RemoteParameters
from zbot.remote.profiles import profile_to_show
from zbot.remote.service_calls import ServiceCalls
from zbot.remote.types import interface
from zbot.wire.tokens import EndpointToken

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from typing_extensions import Self

    from zbot.graph.snapshot import Snapshot, Token
    from zbot.node.client import Client
    from zbot.node.publisher import Publisher
    from zbot.observer.shared_entities import EntityReference
    from zbot.parameters.parameter import Parameter
    from zbot.tf2.diagnosis import TransformMonitor


_PUBLISH_DEPTH = 10
_END_S = 2.0  #: longest wait for a callback at the end
#: Longest wait for an answer of a node, in seconds.
PATIENCE_S = 10.0


def read_only_error(what: str) -> ViewerError:
    """Return the error that a read-only page tried to change something."""
    return ViewerError(f"this page is read-only: {what} is not possible (zbot web --read-only)")


class System:
    """Graph, topics, services and actions of a domain. Any thread may call any method.

    Args:
        read_only: If true, pages cannot publish, call services, set parameters or send goals.
        domain_id: 0 to 232. None means the domain that `zbot.init` would use.

    Attributes:
        logs: The last lines of `/rosout`.
        parameters: Client of all nodes' parameters. `set_parameters` checks `read_only` too.
        revision: A number that grows with every change of the graph.

    Raises:
        SessionError: Zenoh cannot open a session.
        SettingError: The Zenoh configuration file is unusable, or the domain is out of range.
    """

    def __init__(self, *, read_only: bool = False, domain_id: int | None = None) -> None:
        self.read_only = read_only
        self.logs = LogRing()
        self.revision = 0
        self._callbacks: list[Callable[[], None]] = []
        self._lock = threading.RLock()
        self._feeds: dict[tuple[str, str | None], Feed] = {}
        self._shared_entities = SharedEntities()
        self._seen: tuple[int, Snapshot] | None = None
        self.context = Context()
        self.context.init([], domain_id=domain_id)
        try:
            self._open()
        except BaseException:
            self.context.shutdown()
            raise

    def _open(self) -> None:
        self.node = Node(
            f"_zbot_web_{os.getpid()}",
            context=self.context,
            use_global_arguments=False,
            enable_rosout=False,
            start_parameter_services=False,
        )
        # Pages show the problems of topics, so the terminal should not repeat them.
        set_logger_level(self.node.get_logger().name, LoggingSeverity.FATAL)
        self.parameters = RemoteParameters(ServiceCalls(self.node, answer_timeout_s=PATIENCE_S))
        log_type: Any = get_interface("rcl_interfaces/msg/Log")
        self.node.create_subscription(
            log_type, ROSOUT_TOPIC, self.logs.add, qos_profile_rosout_default
        )
        self.context.graph.watch()
        self.context.graph.add_listener(self._on_token)
        self._spinner = SpinThread(self.node, "zbot web", _log_error)

    @property
    def domain_id(self) -> int:
        """The domain, 0 to 232."""
        return self.context.get_domain_id()

    @property
    def node_name(self) -> str:
        """The full name of the hidden node of all pages."""
        return self.node.get_fully_qualified_name()

    def close(self) -> None:
        """Leave the domain. A second call does nothing."""
        self.context.shutdown()
        self._spinner.join(_END_S)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def snapshot(self) -> Snapshot:
        """Return the graph as it is now. Until the next change, return the same object."""
        seen = self._seen
        revision = self.revision
        if seen is None or seen[0] != revision:
            seen = self._seen = (revision, self.context.graph.snapshot())
        return seen[1]

    def on_change(self, callback: Callable[[], None]) -> Callable[[], None]:
        """Call a quick function at each change of the graph, in the thread that noticed the change.

        Returns:
            A function that ends the calls. A second call of this function does nothing.
        """
        with self._lock:
            self._callbacks.append(callback)

        def undo() -> None:
            with self._lock:
                if callback in self._callbacks:
                    self._callbacks.remove(callback)

        return undo

    def _on_token(self, token: Token, _appeared: bool) -> None:
        # This method must not acquire `_lock`. Another thread may hold `_lock` while it declares an
        # entity. When many tokens arrive together, that declaration waits for the end of this
        # method, so both threads would wait for ever.
        self.revision += 1
        topic = token.name if isinstance(token, EndpointToken) else None
        for feed in list(self._feeds.values()):
            if feed.topic == topic and feed.asked_type is None and feed.is_wanted:
                self._spinner.executor.create_task(self._subscribe, feed)
        for callback in list(self._callbacks):
            callback()

    def watch(
        self, topic: str, type_name: str | None = None, *, keep: int = 0, is_active: bool = True
    ) -> Watch:
        """Return a watch of a topic. Watches of the same topic and type share one subscription.

        Args:
            topic: Full name. The topic may have no nodes yet.
            type_name: Full name of the type. None means the type in the graph.
            keep: The number of messages to keep for `Watch.since`.
            is_active: Whether the watch receives messages from the start. Otherwise it receives
                messages after `Watch.resume`.
        """
        key = (topic, type_name)
        with self._lock:
            feed = self._feeds.get(key)
            if feed is None:
                feed = Feed(topic, type_name, self._subscribe, self._unsubscribe)
                self._feeds[key] = feed
            return Watch(feed, keep=keep, is_active=is_active, forget=self._forget)

    @property
    def watched_topics(self) -> list[str]:
        """The topics that have a subscription now, sorted."""
        with self._lock:
            return sorted(
                feed.topic for feed in self._feeds.values() if feed.subscription is not None
            )

    def _subscribe(self, feed: Feed) -> None:
        """Subscribe. If all other nodes use another type now, subscribe again with that type."""
        with self._lock:
            if not feed.is_wanted:
                return
            types = self._types_of(feed.topic) if feed.asked_type is None else [feed.asked_type]
            if feed.subscription is not None:
                if not types or feed.type_name in types:
                    return
                self.node.destroy_subscription(feed.forget_subscription())
            feed.set_type(types[0] if types else None)
            if feed.type_name is None:
                return
            try:
                if find_spec(feed.type_name) is None:
                    self._learn(feed)
                    return
                message_type = get_message(feed.type_name)
            except ZbotError as error:  # the definition on this machine is wrong
                feed.problem = str(error)
                return
            self._open_subscription(feed, message_type)

    def _open_subscription(self, feed: Feed, message_type: Any) -> None:
        publishers = self.snapshot().publishers(feed.topic)
        profile = profile_to_show([end.qos for end in publishers], QUEUE_DEPTH)
        feed.problem = ""
        feed.decode = self.context.dialect.codec_for(message_type).decode
        try:
            feed.subscription = subscribe_to_payloads(
                self.node, message_type, feed.topic, feed.take, profile
            )
        except NotInitializedError:
            return  # the program has ended meanwhile

    def _types_of(self, topic: str) -> list[str]:
        """Return the types of other nodes' publishers, or of their subscriptions."""
        graph, own = self.snapshot(), self.node.get_name()
        for ends in (graph.publishers(topic), graph.subscriptions(topic)):
            types = [end.type_name for end in ends if end.node != own]
            if types:
                return types
        return []

    def _learn(self, feed: Feed) -> None:
        name = str(feed.type_name)
        if feed.learned_type == name:
            return  # the thread of an earlier call asks the nodes now
        feed.learned_type = name
        feed.problem = f"waiting for the definition of {name} from another node"

        def learn() -> None:
            try:
                self.interface(name)
            except ZbotError as error:
                feed.problem = str(error)
                return
            finally:
                feed.learned_type = None
            self._spinner.executor.create_task(self._subscribe, feed)

        self.context.start_thread(f"zbot type {name}", learn)

    def _unsubscribe(self, feed: Feed) -> None:
        with self._lock:
            subscription = None if feed.is_wanted else feed.forget_subscription()
        if subscription is not None and self.context.ok():
            self.node.destroy_subscription(subscription)

    def _forget(self, feed: Feed) -> None:
        with self._lock:
            key = (feed.topic, feed.asked_type)
            if feed.is_abandoned and self._feeds.get(key) is feed:
                del self._feeds[key]

    def interface(self, type_name: str) -> Any:
        """Return the class of a message, service or action type.

        If this machine has no definition, zbot requests it from the nodes that use the type. This
        may take seconds, so call this method in a thread, with `run_in_thread`.

        Raises:
            UnknownTypeError: No definition of the type was found.
        """
        return interface(self.context, type_name)

    def publisher(self, topic: str, type_name: str) -> EntityReference[Publisher[Any]]:
        """Return a reference to a publisher.

        Raises:
            ViewerError: The page is read-only.
            UnknownTypeError: No definition of the type was found.
            InvalidTopicNameError: The name is not valid in ROS 2.
        """
        self._check_writable("publishing")
        message_type = self.interface(type_name)
        return self._shared_entities.get(
            ("publisher", topic, type_name),
            lambda: self.node.create_publisher(message_type, topic, _PUBLISH_DEPTH),
            self.node.destroy_publisher,
        )

    def repeat(
        self, topic: str, type_name: str, make: Callable[[], Any], rate_hz: float
    ) -> RepeatedPublishing:
        """Publish at a rate until the returned object is released.

        Args:
            topic: Full name.
            type_name: Full name of its type.
            make: Function that returns the message. It is called for each message.
            rate_hz: Messages a second.

        Raises:
            ViewerError: The page is read-only.
            UnknownTypeError: No definition of the type was found.
        """
        return RepeatedPublishing(self.node, self.publisher(topic, type_name), make, rate_hz)

    def client(self, name: str, type_name: str) -> EntityReference[Client[Any, Any]]:
        """Return a reference to a service's client.

        Raises:
            ViewerError: The page is read-only.
            UnknownTypeError: No definition of the type was found.
        """
        self._check_writable("calling services")
        return self._client(name, type_name)

    def reader(self, name: str, type_name: str) -> EntityReference[Client[Any, Any]]:
        """Return a reference to a client of a service that changes nothing.

        This also works on a read-only page.

        Raises:
            UnknownTypeError: No definition of the type was found.
        """
        return self._client(name, type_name)

    def _client(self, name: str, type_name: str) -> EntityReference[Client[Any, Any]]:
        service_type = self.interface(type_name)
        return self._shared_entities.get(
            ("client", name, type_name),
            lambda: self.node.create_client(service_type, name),
            self.node.destroy_client,
        )

    def transforms(self) -> EntityReference[TransformMonitor]:
        """Return a reference to the monitor of all transforms. See `TransformWatch`."""
        from zbot.tf2.diagnosis import TransformMonitor  # noqa: PLC0415 - few pages need it

        return self._shared_entities.get(
            "transforms", lambda: TransformMonitor(self.node), TransformMonitor.unregister
        )

    def set_parameters(self, node: str, parameters: Sequence[Parameter[Any]]) -> list[Any]:
        """Set parameters of a node, and return a result for each. See `RemoteParameters.set`.

        Raises:
            ViewerError: The page is read-only.
        """
        self._check_writable("setting parameters")
        return self.parameters.set(node, parameters)

    def action_client(
        self, name: str, type_name: str
    ) -> EntityReference[ActionClient[Any, Any, Any]]:
        """Return a reference to an action's client.

        Raises:
            ViewerError: The page is read-only.
            UnknownTypeError: No definition of the type was found.
        """
        self._check_writable("sending goals")
        action_type = self.interface(type_name)
        return self._shared_entities.get(
            ("action", name, type_name),
            lambda: ActionClient(self.node, action_type, name),
            ActionClient.destroy,
        )

    def _check_writable(self, what: str) -> None:
        if self.read_only:
            raise read_only_error(what)


def _log_error(error: Exception) -> None:
    # A faulty callback must not stop all pages.
    get_logger("zbot.web").error("".join(traceback.format_exception(error)))
