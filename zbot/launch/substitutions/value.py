"""Substitutions for values such as configurations, environment, locals and parameters."""

from __future__ import annotations

import os
import secrets
import socket
from typing import TYPE_CHECKING, Any

from zbot.errors.suggestion import correction
from zbot.launch.environment import how_to_set
from zbot.launch.errors import SubstitutionError
from zbot.launch.log import get_logger
from zbot.launch.substitution import Substitution, describe, normalize, perform
from zbot.log.log_file import get_logging_directory

if TYPE_CHECKING:
    from zbot.launch.context import LaunchContext
    from zbot.launch.substitution import SomeSubstitutionsType


class LaunchConfiguration(Substitution):
    """The value of a launch configuration, which a launch argument or an action sets.

    Args:
        variable_name: Its name.
        default: The value if the configuration is not set.
    """

    def __init__(self, variable_name: SomeSubstitutionsType, *, default: Any | None = None) -> None:
        self.variable_name = normalize(variable_name)
        # ROS 2's launch accepts numbers and bools here too.
        wants_text = isinstance(default, (bool, int, float))
        self.default = (
            None if default is None else normalize(str(default) if wants_text else default)
        )

    def perform(self, context: LaunchContext) -> str:
        """Return the value.

        Raises:
            SubstitutionError: The configuration is not set and has no default.
        """
        name = perform(context, self.variable_name)
        if name in context.launch_configurations:
            return str(context.launch_configurations[name])
        if self.default is not None:
            return perform(context, self.default)
        declared = f"DeclareLaunchArgument('{name}', default_value=...)"
        hint = correction(name, context.launch_configurations)
        hint = hint or f"give it a value: {name}:=VALUE, or declare it above: {declared}"
        raise SubstitutionError(f"launch configuration '{name}' does not exist", hint)

    def describe(self) -> str:
        """Return its name."""
        return f"LaunchConfig({describe(self.variable_name)})"

    __hash__ = Substitution.__hash__

    def __eq__(self, other: object) -> bool:
        """Return whether this is the same object. A comparison with a text is probably a mistake.

        The launch file that compares runs before the configuration has its value.
        """
        if isinstance(other, str):
            name = f"LaunchConfiguration({describe(self.variable_name)})"
            advice = f"condition=IfCondition(EqualsSubstitution({name}, {other!r}))"
            get_logger("launch").warning(
                f"{name} is compared with {other!r} before it has its value, so they always "
                f"differ: write {advice} in the action"
            )
        return self is other


class EnvironmentVariable(Substitution):
    """The value of an environment variable.

    Args:
        name: Its name.
        default_value: The value if the variable is not set.
    """

    def __init__(
        self, name: SomeSubstitutionsType, *, default_value: SomeSubstitutionsType | None = None
    ) -> None:
        self.name = normalize(name)
        self.default_value = None if default_value is None else normalize(default_value)

    def perform(self, context: LaunchContext) -> str:
        """Return the value.

        Raises:
            SubstitutionError: The variable is not set and has no default.
        """
        name = perform(context, self.name)
        if name in context.environment:
            return context.environment[name]
        if self.default_value is not None:
            return perform(context, self.default_value)
        hint = correction(name, context.environment) or how_to_set(name)
        raise SubstitutionError(f"environment variable '{name}' does not exist", hint)

    def describe(self) -> str:
        """Return its name."""
        return f"EnvVar({describe(self.name)})"


class LocalSubstitution(Substitution):
    """The value of a local or of its attribute, e.g. `event.returncode` in an event handler."""

    def __init__(self, expression: str, description: str | None = None) -> None:
        self.expression, self.description = expression, description

    def perform(self, context: LaunchContext) -> str:
        """Return the value as text.

        Raises:
            SubstitutionError: The local or the attribute does not exist.
        """
        value: Any = context.locals
        try:
            for name in self.expression.split("."):
                value = getattr(value, name)
        except AttributeError as error:
            raise SubstitutionError(f"'{self.expression}' is not known here: {error}") from None
        return str(value)

    def describe(self) -> str:
        """Return the expression."""
        return f"Local('{self.description or self.expression}')"


class ForEachVar(Substitution):
    """A value of the present iteration of a `for_each` loop in XML or YAML.

    Args:
        name: The name of the value.
        default_value: The value if the iteration has no value of this name. With None, this is an
            error.
    """

    def __init__(
        self,
        name: SomeSubstitutionsType,
        *,
        default_value: SomeSubstitutionsType | None = None,
    ) -> None:
        self.name = normalize(name)
        self.default_value = None if default_value is None else normalize(default_value)

    @staticmethod
    def get_local_arg_name(name: str) -> str:
        """Return the name of the value in the locals of the launch."""
        return f"for_each_{name}"

    def perform(self, context: LaunchContext) -> str:
        """Return the value as text.

        Raises:
            SubstitutionError: The loop has no value of this name, and no default is given.
        """
        name = perform(context, self.name)
        found = context.get_locals_as_dict().get(self.get_local_arg_name(name))
        if found is not None:
            return str(found)
        if self.default_value is None:
            raise SubstitutionError(f"no enclosing loop has a value '{name}'")
        return perform(context, self.default_value)

    def describe(self) -> str:
        """Return the name."""
        return f"{type(self).__name__}({describe(self.name)})"


class ForLoopIndex(ForEachVar):
    """The number of the present iteration of a `for` loop. The argument is the loop's name."""


class Parameter(Substitution):
    """The value of a parameter that `SetParameter` set for all nodes.

    Args:
        name: Its name.
        default: The value if the parameter is not set.
    """

    def __init__(
        self, name: SomeSubstitutionsType, *, default: SomeSubstitutionsType | None = None
    ) -> None:
        self.name = normalize(name)
        self.default = None if default is None else normalize(default)

    def perform(self, context: LaunchContext) -> str:
        """Return the value.

        Raises:
            SubstitutionError: The parameter is not set and has no default.
        """
        name = perform(context, self.name)
        found = [
            entry[1]
            for entry in context.launch_configurations.get("global_params", ())
            if isinstance(entry, tuple) and entry[0] == name
        ]
        if found:
            return str(found[-1])
        if self.default is not None:
            return perform(context, self.default)
        raise SubstitutionError(f"no parameter '{name}' is set here")

    def describe(self) -> str:
        """Return its name."""
        return f"Parameter({describe(self.name)})"


class AnonName(Substitution):
    """A unique name. Within one launch, the same argument gives the same result."""

    def __init__(self, name: SomeSubstitutionsType) -> None:
        self.name = normalize(name)

    def perform(self, context: LaunchContext) -> str:
        """Return the name, which contains host name, process id and a random number."""
        name = perform(context, self.name)
        key = f"anon {name}"
        made: str | None = context.get_locals_as_dict().get(key)
        if made is None:
            host = "".join(c if c.isalnum() else "_" for c in socket.gethostname())
            made = f"{name}_{host}_{os.getpid()}_{secrets.randbelow(2**32)}"
            context.extend_globals({key: made})
        return made


class ThisLaunchFile(Substitution):
    """The path of the launch file that contains this substitution."""

    _local = "current_launch_file_path"

    def perform(self, context: LaunchContext) -> str:
        """Return the path.

        Raises:
            SubstitutionError: The substitution is used outside of a launch file.
        """
        path: str | None = context.get_locals_as_dict().get(self._local)
        if path is None:
            raise SubstitutionError(f"{self.describe()} is used outside of a launch file")
        return path


class ThisLaunchFileDir(ThisLaunchFile):
    """The folder of the launch file that contains this substitution."""

    _local = "current_launch_file_directory"


class LaunchLogDir(Substitution):
    """The folder of this launch's log files."""

    def perform(self, context: LaunchContext) -> str:
        """Return the folder."""
        return str(context.writer.folder or get_logging_directory())


class FileContent(Substitution):
    """The content of a file."""

    def __init__(self, path: SomeSubstitutionsType) -> None:
        self.path = normalize(path)

    def perform(self, context: LaunchContext) -> str:
        """Return the content.

        Raises:
            SubstitutionError: The file cannot be read.
        """
        path = perform(context, self.path)
        try:
            with open(path, encoding="utf-8") as file:  # noqa: PTH123 - Path("") would be "."
                return file.read()
        except (OSError, UnicodeDecodeError) as error:
            reason = getattr(error, "strerror", None) or str(error)
            raise SubstitutionError(f"cannot read '{path}': {reason}") from error

    def describe(self) -> str:
        """Return the path."""
        return f"FileContent({describe(self.path)})"
