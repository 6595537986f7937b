"""Components: accepted where launch files name them, and told to be of another world."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.launch.action import Action
from zbot.launch.substitution import describe, normalize, perform

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot.launch.condition import Condition
    from zbot.launch.context import LaunchContext
    from zbot.launch.substitution import SomeSubstitutionsType

_REASON = (
    "components are C++ libraries, which zbot cannot load; start each as "
    "Node(package=..., executable=...)"
)


class ComposableNode:
    """A component that was to be loaded."""

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


class _NoComponents(Action):
    """Says that components cannot be loaded; the rest of the launch goes on."""

    def __init__(self, descriptions: Iterable[ComposableNode] | None, **options: Any) -> None:
        super().__init__(**options)
        self.composable_node_descriptions = list(descriptions or ())

    def execute(self, context: LaunchContext) -> None:
        """Say so, and let the launch end with exit code 1."""
        where = f"{self.origin.path}:{self.origin.line}: " if self.origin else ""
        plugins = [perform(context, one.node_plugin) for one in self.composable_node_descriptions]
        told = f" of {', '.join(plugins)}" if plugins else ""
        text = f"{where}{self._what(context)}{told} is left out: {_REASON}"
        context.journal.error("launch_ros", text)
        context.failed = True

    def _what(self, context: LaunchContext) -> str:
        raise NotImplementedError


class ComposableNodeContainer(_NoComponents):
    """A container for components; the arguments are those of `Node`."""

    def __init__(
        self,
        *,
        name: SomeSubstitutionsType = "",
        namespace: SomeSubstitutionsType = "",
        composable_node_descriptions: Iterable[ComposableNode] | None = None,
        condition: Condition | None = None,
        **options: Any,
    ) -> None:
        super().__init__(composable_node_descriptions, condition=condition)
        self.name, self.namespace, self.options = normalize(name), normalize(namespace), options

    def _what(self, context: LaunchContext) -> str:
        return f"the container '{perform(context, self.name)}'"

    def describe(self) -> str:
        """Return the name."""
        return f"ComposableNodeContainer({describe(self.name)})"


class LoadComposableNodes(_NoComponents):
    """Components to load into a container."""

    def __init__(
        self,
        *,
        composable_node_descriptions: Iterable[ComposableNode],
        target_container: Any,
        **options: Any,
    ) -> None:
        super().__init__(composable_node_descriptions, **options)
        self.target_container = target_container

    def _what(self, context: LaunchContext) -> str:
        del context
        return "the loading"
