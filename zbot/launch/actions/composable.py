"""Actions for components (composable nodes). They report that zbot cannot load components."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.launch.action import Action
from zbot.launch.substitution import describe, normalize, perform
from zbot.package.errors import NotRunnableError
from zbot.package.unavailable import Unavailable

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
    """Description of a component, which zbot does not load."""

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


class _UnsupportedComponents(Action):
    """Reports components that zbot cannot load. The rest of the launch continues."""

    def __init__(self, descriptions: Iterable[ComposableNode] | None, **options: Any) -> None:
        super().__init__(**options)
        self.composable_node_descriptions = list(descriptions or ())

    def execute(self, context: LaunchContext) -> None:
        """Log an error and set the exit code of the launch to 1.

        Raises:
            NotRunnableError: The launch is strict.
        """
        where = f"{self.origin.path}:{self.origin.line}: " if self.origin else ""
        plugins = [perform(context, one.node_plugin) for one in self.composable_node_descriptions]
        details = f" of {', '.join(plugins)}" if plugins else ""
        text = f"{where}{self._subject(context)}{details} is left out: {_REASON}"
        if context.strict:
            kind = Unavailable("a C++ library", "start it as Node(package=..., executable=...)")
            raise NotRunnableError(f"{self._subject(context)}{details}", kind)
        context.writer.error("launch_ros", text)
        context.failed = True

    def _subject(self, context: LaunchContext) -> str:
        raise NotImplementedError


class ComposableNodeContainer(_UnsupportedComponents):
    """A container for components. It has the arguments of `Node`, but zbot does not start it."""

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

    def _subject(self, context: LaunchContext) -> str:
        return f"the container '{perform(context, self.name)}'"

    def describe(self) -> str:
        """Return the name."""
        return f"ComposableNodeContainer({describe(self.name)})"


class LoadComposableNodes(_UnsupportedComponents):
    """Components for a container. zbot does not load the components."""

    def __init__(
        self,
        *,
        composable_node_descriptions: Iterable[ComposableNode],
        target_container: Any,
        **options: Any,
    ) -> None:
        super().__init__(composable_node_descriptions, **options)
        self.target_container = target_container

    def _subject(self, context: LaunchContext) -> str:
        del context
        return "the loading"
