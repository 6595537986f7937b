"""Action that runs an executable of a package as a node, with name, parameters and remaps."""

from __future__ import annotations

import os
from collections import Counter
from shlex import quote
from subprocess import list2cmdline
from typing import TYPE_CHECKING, Any

from zbot.launch.actions.execute import ExecuteProcess
from zbot.launch.actions.ros_names import (
    NAMESPACE,
    PARAMETERS,
    REMAPS,
    absolute,
    join_namespace,
)
from zbot.launch.errors import EntityTypeError
from zbot.launch.parameters import normalize_parameters, to_words
from zbot.launch.substitution import describe, normalize, perform
from zbot.package.unavailable import LEFT_OUT_VARIABLE
from zbot.package.workspace import FIRST_VARIABLE, VARIABLE, search_roots
from zbot.package.zbot_command import zbot_command

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from zbot.launch.action import Action
    from zbot.launch.actions.executable import Prepared
    from zbot.launch.context import LaunchContext
    from zbot.launch.entity import LaunchDescriptionEntity
    from zbot.launch.frontend.entity import Entity
    from zbot.launch.frontend.parser import Parser
    from zbot.launch.parameters import SomeParameters
    from zbot.launch.substitution import SomeSubstitutionsType, Substitution

_KEY = "unique_ros_node_names"  # launch_ros uses the same key
_LEFT_OUT = "zbot_left_out_nodes"


class Node(ExecuteProcess):
    """Run a node.

    Args:
        executable: The executable, or a path if there is no package.
        package: The package of the executable.
        name: The node's name. None keeps the name in the node's code.
        namespace: The node's namespace.
        exec_name: The name of the process. None means the name of the executable.
        parameters: Dictionaries and parameter files. A later value replaces an earlier value.
        remappings: Pairs of a name and its replacement.
        ros_arguments: Words to add after `--ros-args`.
        arguments: Words for the node itself.
        options: The options of `ExecuteProcess`.
    """

    UNSPECIFIED_NODE_NAME = "<node_name_unspecified>"
    UNSPECIFIED_NODE_NAMESPACE = "<node_namespace_unspecified>"

    def __init__(
        self,
        *,
        executable: SomeSubstitutionsType,
        package: SomeSubstitutionsType | None = None,
        name: SomeSubstitutionsType | None = None,
        namespace: SomeSubstitutionsType | None = None,
        exec_name: SomeSubstitutionsType | None = None,
        parameters: Iterable[SomeParameters] | None = None,
        remappings: Iterable[tuple[SomeSubstitutionsType, SomeSubstitutionsType]] | None = None,
        ros_arguments: Iterable[SomeSubstitutionsType] | None = None,
        arguments: Iterable[SomeSubstitutionsType] | None = None,
        **options: Any,
    ) -> None:
        self.package = None if package is None else normalize(package)
        self.executable = normalize(executable)
        super().__init__(cmd=[self.executable], name=exec_name, **options)
        # Tests of launch_ros read these two attributes as `_Node__parameters` and
        # `_Node__remappings`.
        self.__parameters = normalize_parameters(parameters or ())
        self.__remappings = [_pair(remapping) for remapping in remappings or ()]
        self.arguments = [normalize(word) for word in _listed(arguments)]
        self.ros_arguments = [normalize(word) for word in _listed(ros_arguments)]
        self._name = _optional(name)
        self._namespace = _optional(namespace)
        self.node_name = self.UNSPECIFIED_NODE_NAME
        self.expanded_node_namespace = self.UNSPECIFIED_NODE_NAMESPACE
        self.expanded_remapping_rules: list[tuple[str, str]] = []

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:
        """Return the class and the constructor options for a `node` tag."""
        from zbot.launch.frontend.ros_tags import node_options  # noqa: PLC0415 - cycle

        return cls, node_options(entity, parser)

    @property
    def parameters(self) -> list[Any]:
        """Dictionaries and files. A later value replaces an earlier value."""
        return self.__parameters

    @property
    def remappings(self) -> list[tuple[list[Substitution], list[Substitution]]]:
        """Pairs of a name and its replacement."""
        return self.__remappings

    @property
    def node_package(self) -> list[Substitution] | None:
        """The package."""
        return self.package

    @property
    def node_executable(self) -> list[Substitution]:
        """The executable."""
        return self.executable

    @property
    def is_fully_qualified(self) -> bool:
        """Whether the launch gives the node a name."""
        return self._name is not None

    def is_node_name_fully_specified(self) -> bool:
        """Return whether the launch gave the node a name and a namespace."""
        unknown = (self.UNSPECIFIED_NODE_NAME, self.UNSPECIFIED_NODE_NAMESPACE)
        return not any(text in self.node_name for text in unknown)

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        """Start the node, unless the launch is ending. Warn if another node has the same name.

        Raises:
            ZbotError: The package or the executable does not exist.
        """
        following = super().execute(context)
        is_started = bool(self.process_details)  # a program that cannot run in zbot is left out
        if self._name is not None and is_started and not context.is_shutdown:
            name = self.node_name.removeprefix(self.UNSPECIFIED_NODE_NAMESPACE)
            add_node_name(context, name)
        return following

    def prepare(self, context: LaunchContext) -> Prepared:
        """Return the command line after substitution.

        Raises:
            ZbotError: The package or the executable does not exist.
        """
        executable = perform(context, self.executable)
        words = [executable]
        if self.package is not None:
            package = perform(context, self.package)
            if context.find_program is not None:
                context.find_program(package, executable)
            words = self._quoted([*zbot_command(), "run", package, executable])
        words += self._own_words(context)
        description = self.process_description
        name = perform(context, description.name) if description.name else ""
        name = name or executable.replace("\\", "/").rpartition("/")[2]
        prepared = description.prepare(context, [*words, *self._ros_words(context)], name)
        if prepared.cwd is not None:  # this folder may be in another workspace or in none
            roots = os.pathsep.join(str(root.absolute()) for root, _ in search_roots())
            prepared.env.update({VARIABLE: roots, FIRST_VARIABLE: "1"})
        left_out = context.get_locals_as_dict().get(_LEFT_OUT)
        if left_out:
            prepared.env[LEFT_OUT_VARIABLE] = " ".join(left_out)
        return prepared

    def note_left_out(self, context: LaunchContext) -> None:
        """Tell the nodes that start later that this node is left out.

        A lifecycle manager must not wait for it. A node without a name has that of its executable.
        """
        self._perform_substitutions(context)
        name = self.node_name.removeprefix(self.UNSPECIFIED_NODE_NAMESPACE)
        name = name.replace(self.UNSPECIFIED_NODE_NAME, perform(context, self.executable))
        names: tuple[str, ...] = context.get_locals_as_dict().get(_LEFT_OUT, ())
        context.extend_globals({_LEFT_OUT: (*names, name)})

    def _skip(self, context: LaunchContext) -> None:
        self.note_left_out(context)
        super()._skip(context)

    def _own_words(self, context: LaunchContext) -> list[str]:
        words = [perform(context, word) for word in self.arguments]
        for word in words:
            first, *others = word.split() or [""]
            if others and first.startswith("-") and "=" not in first:
                context.writer.warning(
                    "launch_ros",
                    f"arguments: {word!r} is given as one word; write an item for each word: "
                    f"arguments={word.split()}",
                )
        return words

    def _quoted(self, words: list[str]) -> list[str]:
        """Quote words if a shell runs them. `arguments` and `ros_arguments` stay unquoted."""
        if not self.shell:
            return words
        return [list2cmdline([word]) if os.name == "nt" else quote(word) for word in words]

    def _ros_words(self, context: LaunchContext) -> list[str]:
        self._perform_substitutions(context)
        given = [perform(context, word) for word in self.ros_arguments]
        words: list[str] = []
        if self._name is not None:
            words += ["-r", f"__node:={perform(context, self._name)}"]
        if self.expanded_node_namespace != self.UNSPECIFIED_NODE_NAMESPACE:
            words += ["-r", f"__ns:={self.expanded_node_namespace}"]
        shared = context.launch_configurations.get(PARAMETERS, [])
        words += to_words(context, [*shared, *self.parameters])
        for source, target in self.expanded_remapping_rules:
            words += ["-r", f"{source}:={target}"]
        words = [*given, *self._quoted(words)]
        return ["--ros-args", *words] if words else []

    def _perform_substitutions(self, context: LaunchContext) -> None:
        """Set the final names and remaps. Extensions of launch_ros call this private method."""
        pushed: str | None = context.launch_configurations.get(NAMESPACE)
        if pushed is not None or self._namespace is not None:
            own = perform(context, self._namespace or ())
            self.expanded_node_namespace = absolute(join_namespace(pushed or "", own))
        name = perform(context, self._name or ()) or self.UNSPECIFIED_NODE_NAME
        self.node_name = f"{self.expanded_node_namespace.rstrip('/')}/{name}"
        own_rules = [(perform(context, old), perform(context, new)) for old, new in self.remappings]
        shared = context.launch_configurations.get(REMAPS, [])
        self.expanded_remapping_rules = [*shared, *own_rules]

    def describe(self) -> str:
        """Return package and executable."""
        package = "" if self.package is None else f"package={describe(self.package)}, "
        return f"{type(self).__name__}({package}executable={describe(self.executable)})"


def _pair(remap: Any) -> tuple[list[Substitution], list[Substitution]]:
    if not isinstance(remap, (tuple, list)) or len(remap) != 2:
        raise EntityTypeError("a remapping", "a pair ('from', 'to')", remap)
    return normalize(remap[0]), normalize(remap[1])


def _optional(value: SomeSubstitutionsType | None) -> list[Substitution] | None:
    return None if value is None else normalize(value)


def _listed(words: Any) -> list[Any]:
    """Return words as a list. A string becomes a list of one word."""
    if words is None:
        return []
    return [words] if isinstance(words, str) or hasattr(words, "perform") else list(words)


def _counts(context: LaunchContext) -> Counter[str]:
    counts: Counter[str] | None = context.get_locals_as_dict().get(_KEY)
    if counts is None:
        counts = Counter()
        context.extend_globals({_KEY: counts})
    return counts


def add_node_name(context: LaunchContext, node_name: str) -> None:
    """Count a node, and log a warning if its name was counted before."""
    counts = _counts(context)
    counts[node_name] += 1
    if counts[node_name] > 1:
        text = f"there are now at least {counts[node_name]} nodes with the name {node_name}"
        context.writer.warning("launch_ros", f"{text} created within this launch context")


def get_node_name_count(context: LaunchContext, node_name: str) -> int:
    """Return the number of started nodes that have a given name."""
    return _counts(context)[node_name]
