"""Nodes, the named participants of the graph that own publishers, subscriptions and timers."""

from __future__ import annotations

import contextlib
from types import FunctionType
from typing import TYPE_CHECKING, Any, cast

from zbot.context import get_default_context
from zbot.errors import described
from zbot.executor.errors import WrongObjectError
from zbot.executor.set_by_init import set_by_init
from zbot.log import get_logger
from zbot.names import (
    fully_qualified,
    validate_namespace,
    validate_node_name,
)
from zbot.node.entities import NodeEntities
from zbot.node.errors import NodeNameError
from zbot.node.graph_queries import GraphQueries
from zbot.node.parameter_services import ParameterServices
from zbot.node.parameters import NodeParameters, overrides_of
from zbot.node.rosout import Rosout
from zbot.node.state import NodeState
from zbot.node.time_source import TimeSource
from zbot.node.type_description import TypeDescriptionService
from zbot.parameters.ros_args import Arguments
from zbot.process import main_part
from zbot.qos import (
    QoSProfile,
    as_profile,
    qos_profile_parameter_events,
    qos_profile_rosout_default,
)

if TYPE_CHECKING:
    from typing_extensions import Self

    from zbot.context import Context
    from zbot.executor.clock import Clock
    from zbot.executor.executor import Executor
    from zbot.log import Logger
    from zbot.parameters.parameter import Parameter


# Python's errors name the class of a method: `Node.create_timer() missing ...`. Users know Node.
for _base in (GraphQueries, NodeEntities, NodeParameters):
    for _member in vars(_base).values():
        if isinstance(_member, FunctionType):
            _member.__qualname__ = f"Node.{_member.__name__}"
main_part.warn_at_exit()


class Node(GraphQueries, NodeEntities, NodeParameters):
    """A participant of the graph, as in rclpy.

    Args:
        node_name: Base name: letters, digits and `_`.
        context: The context of the node. `None` means the default context.
        cli_args: Arguments for this node only. The list contains the word `--ros-args` too.
        namespace: Absolute namespace. A missing first `/` is added.
        use_global_arguments: Whether the process's command line applies too.
        enable_rosout: Whether log lines are also published on `/rosout`.
        rosout_qos_profile: Quality of service of `/rosout`.
        start_parameter_services: Whether other nodes can get and set parameters.
        parameter_overrides: Values that replace declared defaults and values of the command line.
        allow_undeclared_parameters: Whether setting an unknown parameter declares it.
        automatically_declare_parameters_from_overrides: Whether to declare all parameters of the
            command line, its files and `parameter_overrides`.
        enable_logger_service: Whether other nodes can get and set the levels of loggers.

    Raises:
        NodeNameError: The name is empty or missing.
        InvalidNodeNameError: The name breaks ROS 2's grammar.
        InvalidNamespaceError: The namespace breaks ROS 2's grammar.
        NotInitializedError: `init()` was not called, or `shutdown()` was called.
        ParametersFileError: A parameter file cannot be read.
        InvalidParameterTypeException: An override has a wrong type, e.g. `use_sim_time: 1`.
    """

    _zbot_state: NodeState = set_by_init("'my_node'")
    _zbot_logger: Logger = set_by_init("'my_node'")

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
        main_part.Program.needs_no_warning = True
        context.require_valid(f"the node {name!r}")
        overrides = overrides_of(arguments.parameters_for(fully_qualified(space, name)))
        self._zbot_state = handle = NodeState(context, arguments, name, space)
        self._zbot_rosout: Rosout | None = None
        self._zbot_time = TimeSource()
        with contextlib.ExitStack() as on_error:  # a node that fails does not stay in the graph
            on_error.enter_context(context.until_shutdown(f"the node {name!r}"))
            on_error.callback(Node.destroy_node, self)
            context.add_node(self, handle.full_name)
            self._zbot_logger = get_logger(handle.logger_name)
            if enable_rosout:
                self._zbot_rosout = Rosout(self, as_profile(rosout_qos_profile))
            for warning in arguments.warnings_for(handle.full_name):
                self._zbot_logger.warning(warning)
            self._zbot_time.attach_clock(handle.clock)
            handle.parameters.overrides = overrides | {p.name: p for p in parameter_overrides or ()}
            handle.parameters.allow_undeclared = allow_undeclared_parameters
            self._zbot_add_parameter_events()
            if automatically_declare_parameters_from_overrides:
                self._zbot_declare_overrides()
            self._zbot_declare_own()
            handle.check_parameters()
            handle.check_remaps()
            self._zbot_time.attach_node(self)
            if start_parameter_services:
                self._zbot_parameter_services = ParameterServices(self)
            self._zbot_type_descriptions = TypeDescriptionService(self)
            if enable_logger_service:
                from zbot.node.logger_services import LoggingService  # noqa: PLC0415 - few nodes have it

                LoggingService(self)
            on_error.pop_all()

    def _zbot_add_parameter_events(self) -> None:
        from rcl_interfaces.msg import ParameterEvent  # noqa: PLC0415 - the import makes the class

        self._zbot_state.parameter_events = Node.create_publisher(
            self, ParameterEvent, "/parameter_events", qos_profile_parameter_events
        )

    @property
    def context(self) -> Context:
        """The context of the node."""
        return self._zbot_state.context

    @property
    def executor(self) -> Executor | None:
        """The executor that runs the node's callbacks, if any.

        If a program sets this property, the node moves to the new executor.
        """
        return cast("Executor | None", self._zbot_state.executor)

    @executor.setter
    def executor(self, new_executor: Executor | None) -> None:
        current = self._zbot_state.executor
        if current is new_executor:
            return
        if new_executor is not None and not hasattr(new_executor, "add_node"):
            raise WrongObjectError(
                f"executor must be an executor, not {described(new_executor)}; nodes use this name "
                "themselves: choose another, e.g. self.my_executor"
            )
        if current is not None:
            current.remove_node(self)
        self._zbot_state.executor = None
        # A program's own executor class may add the node without setting this attribute.
        if new_executor is not None and new_executor.add_node(self):
            self._zbot_state.executor = new_executor

    def get_name(self) -> str:
        """Return the base name."""
        return self._zbot_state.token.node

    def get_namespace(self) -> str:
        """Return the absolute namespace."""
        return self._zbot_state.token.namespace

    def get_fully_qualified_name(self) -> str:
        """Return the full name, which is the namespace and the base name."""
        return self._zbot_state.full_name

    def get_logger(self) -> Logger:
        """Return the logger that writes under the node's name."""
        return self._zbot_logger

    def get_clock(self) -> Clock:
        """Return the node's clock, which shows the system's time or simulated time."""
        return self._zbot_state.clock

    def resolve_topic_name(self, topic: str, *, only_expand: bool = False) -> str:
        """Return the full name of a topic. The name is remapped if `only_expand` is false.

        Raises:
            InvalidTopicNameError: The name breaks ROS 2's grammar.
        """
        return self._zbot_state.resolve(topic, is_service=False, only_expand=only_expand)

    def resolve_service_name(self, service: str, *, only_expand: bool = False) -> str:
        """Return the full name of a service. The name is remapped if `only_expand` is false.

        Raises:
            InvalidServiceNameError: The name breaks ROS 2's grammar.
        """
        return self._zbot_state.resolve(service, is_service=True, only_expand=only_expand)

    def destroy_node(self) -> None:
        """Remove the node and all its entities from the graph. This method may be called twice."""
        handle = self._zbot_state
        if handle.is_destroyed:
            return
        handle.is_destroyed = True
        if handle.context.is_inherited:
            return  # the node of the parent process stays in the graph
        # As in rclpy, remove_node() is called only if the executor is one of zbot's classes.
        if handle.executor is not None and handle.executor is handle.ready_queue.executor:
            handle.executor.remove_node(self)
        if self._zbot_rosout is not None:
            self._zbot_rosout.close()
        self._zbot_time.detach_node()
        handle.destroy()
        handle.context.remove_node(self, handle.full_name)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *exc_info: object) -> None:
        self.destroy_node()
