"""Nodes: named participants that own publishers, subscriptions and timers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from zbot.context import get_default_context
from zbot.errors import ArgumentTypeError
from zbot.executor.guard_condition import GuardCondition
from zbot.executor.timer import Rate, Timer
from zbot.interfaces.type_support import check_is_valid_msg_type, check_is_valid_srv_type
from zbot.log import get_logger
from zbot.names import (
    fully_qualified,
    validate_namespace,
    validate_node_name,
)
from zbot.node.client import Client
from zbot.node.errors import InvalidPeriodError, NodeNameError
from zbot.node.graph_queries import GraphQueries
from zbot.node.parameter_services import ParameterServices
from zbot.node.parameters import NodeParameters, overrides_of
from zbot.node.private_aliases import PrivateAliases
from zbot.node.publisher import Publisher
from zbot.node.qos_events import PublisherEventCallbacks, SubscriptionEventCallbacks
from zbot.node.rosout import Rosout
from zbot.node.service import Service
from zbot.node.state import NodeState
from zbot.node.subscription import ContentFilterOptions, Subscription
from zbot.node.time_source import TimeSource
from zbot.node.type_description import TypeDescriptionService
from zbot.parameters.ros_args import Arguments
from zbot.process.memory import spare_the_collector
from zbot.qos import (
    QoSProfile,
    as_profile,
    qos_profile_parameter_events,
    qos_profile_rosout_default,
    qos_profile_services_default,
)
from zbot.time import S_TO_NS
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from types import TracebackType

    from typing_extensions import Self

    from zbot.context import Context
    from zbot.executor.callback_group import CallbackGroup
    from zbot.executor.clock import Clock
    from zbot.executor.executor import Executor
    from zbot.executor.waitable import Waitable
    from zbot.log import Logger
    from zbot.parameters.parameter import Parameter
    from zbot.parameters.qos_overrides import QoSOverridingOptions

MsgT = TypeVar("MsgT")
EntityT = TypeVar("EntityT")


class _Listing:
    """A read-only view of a node's entities, which a subclass may replace by an attribute."""

    def __init__(self, attribute: str) -> None:
        self._attribute = attribute

    def __get__(self, node: Node, owner: type[Node]) -> Iterator[Any]:
        return iter(list(getattr(node.handle, self._attribute)))


class Node(GraphQueries, PrivateAliases, NodeParameters):
    """A participant of the graph, as in rclpy.

    Args:
        node_name: Base name: letters, digits and `_`.
        context: The context to live in; the default one if left out.
        cli_args: Arguments for this node alone, with their `--ros-args`.
        namespace: Absolute, or taken as if it were.
        use_global_arguments: Whether the process's command line applies too.
        enable_rosout: Whether log lines are also published on `/rosout`.
        rosout_qos_profile: Quality of service of `/rosout`.
        start_parameter_services: Whether other nodes can get and set parameters.
        parameter_overrides: Win over the defaults of declarations and over the command line.
        allow_undeclared_parameters: Whether setting an unknown parameter declares it.
        automatically_declare_parameters_from_overrides: Declare whatever the command line, its
            files and `parameter_overrides` have.
        enable_logger_service: Whether other nodes can ask for the loggers' levels and set them.

    Raises:
        NodeNameError: The name is empty or missing.
        InvalidNodeNameError: The name breaks ROS 2's grammar.
        InvalidNamespaceError: So does the namespace.
        NotInitializedError: `init()` was not called, or `shutdown()` was.
        ParametersFileError: A parameter file cannot be read.
        InvalidParameterTypeException: An override is of another type, e.g. that of `use_sim_time`.
    """

    publishers = _Listing("publishers")
    subscriptions = _Listing("subscriptions")
    services = _Listing("services")
    clients = _Listing("clients")
    timers = _Listing("timers")
    guards = _Listing("guards")

    def __init__(
        self,
        node_name: str,
        *,
        context: Context | None = None,
        cli_args: list[str] | None = None,
        namespace: str | None = None,
        use_global_arguments: bool = True,
        enable_rosout: bool = True,
        rosout_qos_profile: QoSProfile | int = qos_profile_rosout_default,
        start_parameter_services: bool = True,
        parameter_overrides: list[Parameter[Any]] | None = None,
        allow_undeclared_parameters: bool = False,
        automatically_declare_parameters_from_overrides: bool = False,
        enable_logger_service: bool = False,
    ) -> None:
        if not isinstance(node_name, str) or not node_name:
            raise NodeNameError(node_name)
        context = context or get_default_context()
        own = Arguments.parse(cli_args) if cli_args else Arguments()
        arguments = own.merged(context.arguments) if use_global_arguments else own
        name = arguments.node_name_for(node_name)
        validate_node_name(name)
        space = arguments.namespace_for(node_name) or namespace or "/"
        space = space if space.startswith("/") else f"/{space}"
        validate_namespace(space)
        overrides = overrides_of(arguments.parameters_for(fully_qualified(space, name)))
        self._zbot_state = handle = NodeState(context, arguments, name, space)
        context.add_node(self)
        self._zbot_logger = get_logger(handle.logger_name)
        self._zbot_rosout = Rosout(self, as_profile(rosout_qos_profile)) if enable_rosout else None
        self._zbot_time = TimeSource()
        self._zbot_time.attach_clock(handle.clock)
        handle.parameters.overrides = overrides | {p.name: p for p in parameter_overrides or ()}
        handle.parameters.allow_undeclared = allow_undeclared_parameters
        self._zbot_add_parameter_events()
        if automatically_declare_parameters_from_overrides:
            self._zbot_declare_overrides()
        self._zbot_declare_own()
        self._zbot_time.attach_node(self)
        if start_parameter_services:
            self._zbot_parameter_services = ParameterServices(handle, self._zbot_resolve)
        self._zbot_type_descriptions = TypeDescriptionService(self)
        if enable_logger_service:
            from zbot.node.logger_services import LoggingService  # noqa: PLC0415 - few nodes have it

            LoggingService(self)

    def _zbot_add_parameter_events(self) -> None:
        from rcl_interfaces.msg import ParameterEvent  # noqa: PLC0415 - made at first import

        self._zbot_state.parameter_events = Node.create_publisher(
            self, ParameterEvent, "/parameter_events", qos_profile_parameter_events
        )

    # -- who it is -----------------------------------------------------------------------------

    @property
    def handle(self) -> NodeState:
        """The node's own state; not for user code."""
        return self._zbot_state

    @property
    def context(self) -> Context:
        """The context that the node lives in."""
        return self._zbot_state.context

    @property
    def executor(self) -> Executor | None:
        """The executor that runs its callbacks, if any; set it to move the node there."""
        return self._zbot_state.executor

    @executor.setter
    def executor(self, new_executor: Executor | None) -> None:
        current = self._zbot_state.executor
        if current is new_executor:
            return
        if current is not None:
            current.remove_node(self)
        self._zbot_state.executor = None
        # An executor of another make only says whether it took the node.
        if new_executor is not None and new_executor.add_node(self):
            self._zbot_state.executor = new_executor

    def get_name(self) -> str:
        """Return the base name."""
        return self._zbot_state.token.node

    def get_namespace(self) -> str:
        """Return the absolute namespace."""
        return self._zbot_state.token.namespace

    def get_fully_qualified_name(self) -> str:
        """Return namespace and name."""
        return self._zbot_state.full_name

    def get_logger(self) -> Logger:
        """Return the logger that writes under the node's name."""
        return self._zbot_logger

    def get_clock(self) -> Clock:
        """Return the node's clock: the system's time, or simulated time."""
        return self._zbot_state.clock

    def resolve_topic_name(self, topic: str, *, only_expand: bool = False) -> str:
        """Return the full name of a topic: expanded, and remapped unless `only_expand`.

        Raises:
            InvalidTopicNameError: The name breaks ROS 2's grammar.
        """
        return self._zbot_resolve(topic, only_expand=only_expand, is_service=False)

    def resolve_service_name(self, service: str, *, only_expand: bool = False) -> str:
        """Return the full name of a service: expanded, and remapped unless `only_expand`.

        Raises:
            InvalidServiceNameError: The name breaks ROS 2's grammar.
        """
        return self._zbot_resolve(service, only_expand=only_expand, is_service=True)

    def _zbot_resolve(self, name: str, *, only_expand: bool, is_service: bool) -> str:
        return self._zbot_state.resolve(name, only_expand=only_expand, is_service=is_service)

    # -- what it has ---------------------------------------------------------------------------

    def create_publisher(
        self,
        msg_type: type[MsgT],
        topic: str,
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: Any = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        publisher_class: type[Publisher[Any]] = Publisher,
    ) -> Publisher[MsgT]:
        """Create a publisher.

        Args:
            msg_type: Message class.
            topic: Relative, `~/private` or absolute name.
            qos_profile: A profile, or the depth of the default one.
            callback_group: Where its events' callbacks run; the node's own if left out.
            event_callbacks: A `PublisherEventCallbacks`.
            qos_overriding_options: Which policies parameters may override.
            publisher_class: A subclass to make instead.

        Raises:
            InvalidTopicNameError: The name breaks ROS 2's grammar.
            NotAMessageTypeError: The class is no message's.
            InvalidHandleError: The node was destroyed.
        """
        handle = self._zbot_alive()
        check_is_valid_msg_type(msg_type)
        name = Node.resolve_topic_name(self, topic)
        qos = self._zbot_overridden("publisher", name, qos_profile, qos_overriding_options)
        token = handle.endpoint(EntityKind.PUBLISHER, name, msg_type, qos)
        publisher = publisher_class(
            handle.context,
            msg_type,
            token,
            logger_name=handle.logger_name,
            callback_group=callback_group or self.default_callback_group,
        )
        publisher.topic = topic
        handle.publishers.append(publisher)
        handle.adviser.add(token, handle.logger_name)
        events = event_callbacks or PublisherEventCallbacks()
        events.attach(publisher, handle.ready_queue, handle.context.graph)
        return cast("Publisher[MsgT]", publisher)

    def create_subscription(
        self,
        msg_type: type[MsgT],
        topic: str,
        callback: Callable[..., Any],
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: Any = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        raw: bool | Literal["payload"] = False,
        content_filter_options: ContentFilterOptions | None = None,
    ) -> Subscription[MsgT]:
        """Create a subscription.

        Args:
            msg_type: Message class.
            topic: Relative, `~/private` or absolute name.
            callback: Takes the message, or the message and a dict of its times and numbers.
            qos_profile: A profile, or the depth of the default one.
            callback_group: Decides beside what the callback may run; the node's own if left out.
            event_callbacks: A `SubscriptionEventCallbacks`.
            qos_overriding_options: Which policies parameters may override.
            raw: Give the callback each message as the bytes of ROS 2's CDR; with `"payload"`, as
                the bytes that were sent, undecoded.
            content_filter_options: An expression that is true of the messages that are wanted.

        Raises:
            InvalidTopicNameError: The name breaks ROS 2's grammar.
            CallbackSignatureError: The callback takes neither one nor two arguments.
            ContentFilterError: The expression does not fit the type.
            NotAMessageTypeError: The class is no message's.
            InvalidHandleError: The node was destroyed.
        """
        handle = self._zbot_alive()
        check_is_valid_msg_type(msg_type)
        name = Node.resolve_topic_name(self, topic)
        qos = self._zbot_overridden("subscription", name, qos_profile, qos_overriding_options)
        subscription = Subscription(
            handle.context,
            msg_type,
            callback,
            handle.endpoint(EntityKind.SUBSCRIPTION, name, msg_type, qos),
            ready_queue=handle.ready_queue,
            callback_group=callback_group or self.default_callback_group,
            raw=raw,
            logger_name=handle.logger_name,
            content_filter=content_filter_options,
        )
        subscription.topic = topic
        handle.subscriptions.append(subscription)
        handle.adviser.add(subscription.token, handle.logger_name)
        handle.add(subscription)
        events = event_callbacks or SubscriptionEventCallbacks()
        events.attach(subscription, handle.ready_queue, handle.context.graph)
        subscription.start()
        return subscription

    def create_service(
        self,
        srv_type: type[Any],
        srv_name: str,
        callback: Callable[[Any, Any], Any],
        *,
        qos_profile: QoSProfile | int = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> Service[Any, Any]:
        """Create a service.

        Args:
            srv_type: Service class.
            srv_name: Relative, `~/private` or absolute name.
            callback: Takes a request and an empty response, and returns a response; may be a
                coroutine function.
            qos_profile: A profile, or the depth of the default one; shown in the graph only.
            callback_group: Decides beside what the callback may run; the node's own if left out.

        Raises:
            InvalidServiceNameError: The name breaks ROS 2's grammar.
            NotAMessageTypeError: The class is no service's.
            InvalidHandleError: The node was destroyed.
        """
        handle = self._zbot_alive()
        check_is_valid_srv_type(srv_type)
        name = Node.resolve_service_name(self, srv_name)
        service: Service[Any, Any] = Service(
            handle.context,
            srv_type,
            callback,
            handle.endpoint(EntityKind.SERVICE, name, srv_type, as_profile(qos_profile)),
            ready_queue=handle.ready_queue,
            callback_group=callback_group or self.default_callback_group,
            logger_name=handle.logger_name,
        )
        service.srv_name = srv_name
        handle.services.append(service)
        handle.add(service)
        return service

    def create_client(
        self,
        srv_type: type[Any],
        srv_name: str,
        *,
        qos_profile: QoSProfile | int = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> Client[Any, Any]:
        """Create a client of a service.

        Args:
            srv_type: Service class.
            srv_name: Relative, `~/private` or absolute name.
            qos_profile: A profile, or the depth of the default one; shown in the graph only.
            callback_group: Decides beside what the callbacks of its futures may run; the node's own
                if left out.

        Raises:
            InvalidServiceNameError: The name breaks ROS 2's grammar.
            NotAMessageTypeError: The class is no service's.
            InvalidHandleError: The node was destroyed.
        """
        handle = self._zbot_alive()
        check_is_valid_srv_type(srv_type)
        name = Node.resolve_service_name(self, srv_name)
        client: Client[Any, Any] = Client(
            handle.context,
            srv_type,
            handle.endpoint(EntityKind.CLIENT, name, srv_type, as_profile(qos_profile)),
            ready_queue=handle.ready_queue,
            callback_group=callback_group or self.default_callback_group,
            logger_name=handle.logger_name,
        )
        client.srv_name = srv_name
        handle.clients.append(client)
        handle.add(client)
        return client

    def create_timer(
        self,
        timer_period_sec: float,
        callback: Callable[..., Any] | None,
        callback_group: CallbackGroup | None = None,
        clock: Clock | None = None,
        autostart: bool = True,
    ) -> Timer:
        """Create a timer.

        Args:
            timer_period_sec: Seconds, 0 or more.
            callback: Called without arguments, or with a `TimerInfo`.
            callback_group: Decides beside what it may run; the node's own if left out.
            clock: The clock that it follows; the node's if left out.
            autostart: Whether it runs before its first `reset()`.

        Raises:
            InvalidPeriodError: The period is negative or no number.
            InvalidHandleError: The node was destroyed.
        """
        handle = self._zbot_alive()
        if not isinstance(timer_period_sec, (int, float)) or not 0 <= timer_period_sec < 2**33:
            raise InvalidPeriodError("a timer's period", timer_period_sec)
        timer = Timer(
            callback,
            callback_group or self.default_callback_group,
            int(float(timer_period_sec) * S_TO_NS),
            clock or handle.clock,
            handle.ready_queue,
            autostart=autostart,
        )
        handle.timers.append(timer)
        handle.add(timer)
        return timer

    def create_guard_condition(
        self, callback: Callable[[], Any], callback_group: CallbackGroup | None = None
    ) -> GuardCondition:
        """Create a callback that any thread can ask for with `trigger()`."""
        handle = self._zbot_alive()
        group = callback_group or self.default_callback_group
        guard = GuardCondition(callback, group, ready_queue=handle.ready_queue)
        handle.guards.append(guard)
        handle.add(guard)
        return guard

    def add_waitable(self, waitable: Waitable[Any]) -> None:
        """Let the node's executor run work of the program's own kind."""
        self._zbot_alive().add_waitable(waitable)

    def remove_waitable(self, waitable: Waitable[Any]) -> None:
        """Run a waitable no more; nothing happens if it is not this node's."""
        self._zbot_state.remove_waitable(waitable)

    @property
    def waitables(self) -> Iterator[Waitable[Any]]:
        """The waitables that were added."""
        return iter([entity.waitable for entity in self._zbot_state.waitables])

    def create_rate(self, frequency: float, clock: Clock | None = None) -> Rate:
        """Create a rate whose `sleep()` gives a loop `frequency` turns a second.

        Raises:
            ArgumentTypeError: The frequency is no number.
            InvalidPeriodError: The frequency is not above 0.
        """
        handle = self._zbot_alive()
        if not isinstance(frequency, (int, float)):
            raise ArgumentTypeError("a rate's frequency", "a number", frequency)
        if not 0 < frequency <= S_TO_NS:
            raise InvalidPeriodError("a rate's frequency", frequency)
        timer = Node.create_timer(self, 1 / frequency, None, clock=clock)
        rate = Rate(timer, handle.context)
        handle.rates.append(rate)
        return rate

    def _zbot_overridden(
        self,
        entity: str,
        topic: str,
        qos: QoSProfile | int,
        options: QoSOverridingOptions | None,
    ) -> QoSProfile:
        """Return a profile as the node's parameters change it, if the options allow that."""
        profile = as_profile(qos)
        if options is None:
            return profile
        from zbot.parameters.qos_overrides import overridden  # noqa: PLC0415 - few nodes have options

        return overridden(self._zbot_state.parameters, entity, topic, profile, options)

    def _zbot_alive(self) -> NodeState:
        handle = self._zbot_state
        if handle.is_destroyed:
            from zbot.errors import InvalidHandleError  # noqa: PLC0415 - the rare case

            raise InvalidHandleError(f"the node {handle.full_name}")
        return handle

    # -- the end -------------------------------------------------------------------------------

    def destroy_publisher(self, publisher: Publisher[Any]) -> bool:
        """Destroy a publisher; return whether it was this node's."""
        if publisher in self._zbot_state.publishers:
            self._zbot_state.adviser.remove(publisher.token)
        return self._zbot_remove(self._zbot_state.publishers, publisher)

    def destroy_subscription(self, subscription: Subscription[Any]) -> bool:
        """Destroy a subscription; return whether it was this node's."""
        if subscription in self._zbot_state.subscriptions:
            self._zbot_state.adviser.remove(subscription.token)
        return self._zbot_remove(self._zbot_state.subscriptions, subscription)

    def destroy_service(self, service: Service[Any, Any]) -> bool:
        """Destroy a service; return whether it was this node's."""
        return self._zbot_remove(self._zbot_state.services, service)

    def destroy_client(self, client: Client[Any, Any]) -> bool:
        """Destroy a client; return whether it was this node's."""
        return self._zbot_remove(self._zbot_state.clients, client)

    def destroy_timer(self, timer: Timer) -> bool:
        """Destroy a timer; return whether it was this node's."""
        return self._zbot_remove(self._zbot_state.timers, timer)

    def destroy_guard_condition(self, guard: GuardCondition) -> bool:
        """Destroy a guard condition; return whether it was this node's."""
        return self._zbot_remove(self._zbot_state.guards, guard)

    def destroy_rate(self, rate: Rate) -> bool:
        """Destroy a rate; return whether it was this node's."""
        handle = self._zbot_state
        return self._zbot_remove(handle.rates, rate) and self._zbot_remove(
            handle.timers, rate.timer
        )

    def _zbot_remove(self, owned: list[EntityT], entity: EntityT) -> bool:
        if entity not in owned:
            return False
        owned.remove(entity)
        self._zbot_state.ready_queue.remove(cast("Any", entity))
        cast("Any", entity).destroy()
        return True

    def destroy_node(self) -> None:
        """Leave the graph with everything the node owns; may be called twice."""
        handle = self._zbot_state
        if handle.is_destroyed:
            return
        handle.is_destroyed = True
        # One of another make has nothing of the node, and is not told, as in rclpy.
        if handle.executor is not None and handle.executor is handle.ready_queue.executor:
            handle.executor.remove_node(self)
        if self._zbot_rosout is not None:
            self._zbot_rosout.close()
        handle.destroy()
        handle.context.remove_node(self)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        exc_type: type[BaseException] | None,
        exc_val: BaseException | None,
        exc_tb: TracebackType | None,
    ) -> None:
        self.destroy_node()


spare_the_collector()
