"""Actions for components (composable nodes), which are C++ libraries in ROS 2.

A component that zbot has as a bundled node runs as a program of its own. The other components, and
the containers, cannot run and are left out.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from zbot.launch.action import Action
from zbot.launch.actions.node import Node
from zbot.launch.not_runnable import leave_out
from zbot.launch.substitution import describe, is_a_substitution, normalize, perform
from zbot.package.bundled_nodes import BUNDLED_COMPONENTS
from zbot.package.errors import NotRunnableError
from zbot.package.unavailable import COMPONENTS

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from zbot.launch.condition import Condition
    from zbot.launch.context import LaunchContext
    from zbot.launch.entity import LaunchDescriptionEntity
    from zbot.launch.substitution import SomeSubstitutionsType

_PACKAGE: Final = "rclcpp_components"
_EXECUTABLE: Final = "component_container"


class ComposableNode:
    """Description of a component."""

    def __init__(
        self,
        *,
        package: SomeSubstitutionsType,
        plugin: SomeSubstitutionsType,
        name: SomeSubstitutionsType | None = None,
        namespace: SomeSubstitutionsType | None = None,
        parameters: Iterable[Any] | None = None,
        remappings: Iterable[Any] | None = None,
        extra_arguments: Iterable[Any] | None = None,
        condition: Condition | None = None,
    ) -> None:
        self.package, self.node_plugin = normalize(package), normalize(plugin)
        self.node_name = None if name is None else normalize(name)
        self.node_namespace = None if namespace is None else normalize(namespace)
        self.parameters, self.remappings = list(parameters or ()), list(remappings or ())
        self.extra_arguments, self.condition = list(extra_arguments or ()), condition

    def bundled(self, plugin: str) -> Node | None:
        """Return the bundled node that does the same as a component, or None if there is none."""
        if plugin not in BUNDLED_COMPONENTS:
            return None
        package, executable = BUNDLED_COMPONENTS[plugin]
        return self.as_node(executable, package)

    def as_node(self, executable: str, package: str | None = None) -> Node:
        """Return an action that runs a program with the name and parameters of the component."""
        return Node(
            package=package,
            executable=executable,
            name=self.node_name,
            namespace=self.node_namespace,
            parameters=self.parameters,
            remappings=self.remappings,
        )


def _load(
    context: LaunchContext, container: str, descriptions: Iterable[ComposableNode]
) -> list[LaunchDescriptionEntity]:
    """Return the bundled nodes of components. Leave out the other components.

    Raises:
        NotRunnableError: The launch is strict, and a component cannot run.
    """
    nodes: list[LaunchDescriptionEntity] = []
    plugins = []
    for description in descriptions:
        if description.condition is not None and not description.condition.evaluate(context):
            continue
        plugin = perform(context, description.node_plugin)
        node = description.bundled(plugin)
        if node is None:
            plugins.append(plugin)
            description.as_node(plugin).note_left_out(context)
        else:
            nodes.append(node)
    if plugins or not nodes:
        details = f" of {', '.join(plugins)}" if plugins else ""
        error = NotRunnableError(f"the container '{container}'{details}", COMPONENTS)
        leave_out(context, error)
    return nodes


class ComposableNodeContainer(Node):
    """A container for components. The components that zbot has run as programs of their own.

    Args:
        name: The container's name.
        namespace: The container's namespace.
        composable_node_descriptions: The components.
        options: The options of `Node`.
    """

    def __init__(
        self,
        *,
        name: SomeSubstitutionsType = "",
        namespace: SomeSubstitutionsType = "",
        composable_node_descriptions: Iterable[ComposableNode] | None = None,
        package: SomeSubstitutionsType = _PACKAGE,
        executable: SomeSubstitutionsType = _EXECUTABLE,
        **options: Any,
    ) -> None:
        super().__init__(
            package=package, executable=executable, name=name, namespace=namespace, **options
        )
        self.name_of_container = normalize(name)
        self.composable_node_descriptions = list(composable_node_descriptions or ())

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity]:
        """Return the bundled nodes of the components, and leave out the other components.

        Raises:
            NotRunnableError: The launch is strict, and a component cannot run.
        """
        name = perform(context, self.name_of_container)
        return _load(context, name, self.composable_node_descriptions)

    def describe(self) -> str:
        """Return the name."""
        return f"ComposableNodeContainer({describe(self.name_of_container)})"


class LoadComposableNodes(Action):
    """Components for a container. The components that zbot has run as programs of their own.

    Args:
        composable_node_descriptions: The components.
        target_container: The name of the container, or the action that starts the container.
        options: The options of `Action`.
    """

    def __init__(
        self,
        *,
        composable_node_descriptions: Iterable[ComposableNode],
        target_container: SomeSubstitutionsType | ComposableNodeContainer,
        **options: Any,
    ) -> None:
        super().__init__(**options)
        self.composable_node_descriptions = list(composable_node_descriptions)
        self.target_container = target_container

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity]:
        """Return the bundled nodes of the components, and leave out the other components.

        Raises:
            NotRunnableError: The launch is strict, and a component cannot run.
        """
        target: Any = self.target_container
        if isinstance(target, ComposableNodeContainer):
            target = target.name_of_container
        name = perform(context, normalize(target)) if is_a_substitution(target) else ""
        return _load(context, name, self.composable_node_descriptions)
