"""Values that the launch holds: configurations, environment, locals, parameters."""

from __future__ import annotations

import os
import secrets
import socket
from typing import TYPE_CHECKING, Any

from zbot.errors import close_matches
from zbot.launch.errors import SubstitutionError
from zbot.launch.substitution import Substitution, describe, normalize, perform

if TYPE_CHECKING:
    from zbot.launch.context import LaunchContext
    from zbot.launch.substitution import SomeSubstitutionsType


def _guess(name: str, known: Any) -> str:
    near = close_matches(name, known, 1)
    return f"did you mean '{near[0]}'?" if near else ""


class LaunchConfiguration(Substitution):
    """The value of a launch argument, or of what an action set.

    Args:
        variable_name: Its name.
        default: The value where nothing has set it.
    """

    def __init__(self, variable_name: SomeSubstitutionsType, *, default: Any | None = None) -> None:
        self.variable_name = normalize(variable_name)
        # launch takes numbers and truth values here, too
        wants_text = isinstance(default, (bool, int, float))
        self.default = (
            None if default is None else normalize(str(default) if wants_text else default)
        )

    def perform(self, context: LaunchContext) -> str:
        """Return the value.

        Raises:
            SubstitutionError: Nothing has set it and it has no default.
        """
        name = perform(context, self.variable_name)
        if name in context.launch_configurations:
            return str(context.launch_configurations[name])
        if self.default is not None:
            return perform(context, self.default)
        hint = _guess(name, context.launch_configurations)
        hint = hint or f"declare it: DeclareLaunchArgument('{name}', default_value=...)"
        raise SubstitutionError(f"launch configuration '{name}' does not exist", hint)

    def describe(self) -> str:
        """Return its name."""
        return f"LaunchConfig({describe(self.variable_name)})"


class EnvironmentVariable(Substitution):
    """The value of an environment variable.

    Args:
        name: Its name.
        default_value: The value where it is not set.
    """

    def __init__(
        self, name: SomeSubstitutionsType, *, default_value: SomeSubstitutionsType | None = None
    ) -> None:
        self.name = normalize(name)
        self.default_value = None if default_value is None else normalize(default_value)

    def perform(self, context: LaunchContext) -> str:
        """Return the value.

        Raises:
            SubstitutionError: It is not set and has no default.
        """
        name = perform(context, self.name)
        if name in context.environment:
            return context.environment[name]
        if self.default_value is not None:
            return perform(context, self.default_value)
        hint = _guess(name, context.environment)
        raise SubstitutionError(f"environment variable '{name}' does not exist", hint)

    def describe(self) -> str:
        """Return its name."""
        return f"EnvVar({describe(self.name)})"


class LocalSubstitution(Substitution):
    """A Python expression about the locals, e.g. `event.returncode` in an event handler."""

    def __init__(self, expression: str, description: str | None = None) -> None:
        self.expression, self.description = expression, description

    def perform(self, context: LaunchContext) -> str:
        """Return the value as text.

        Raises:
            SubstitutionError: There is nothing of that name here.
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
    """A value of the round that a `for_each` loop of a launch file in XML or YAML is in.

    Args:
        name: The value's name.
        default_value: What to return where a round has none; an error if left out.
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
        """Return what the value is called among a launch's locals."""
        return f"for_each_{name}"

    def perform(self, context: LaunchContext) -> str:
        """Return the value as text.

        Raises:
            SubstitutionError: No round has a value of that name.
        """
        name = perform(context, self.name)
        found = context.get_locals_as_dict().get(self.get_local_arg_name(name))
        if found is not None:
            return str(found)
        if self.default_value is None:
            raise SubstitutionError(f"no loop around this has a value '{name}'")
        return perform(context, self.default_value)

    def describe(self) -> str:
        """Return the name."""
        return f"{type(self).__name__}({describe(self.name)})"


class ForLoopIndex(ForEachVar):
    """The number of the round that a `for` loop is in; the name is the loop's."""


class Parameter(Substitution):
    """The value of a parameter that `SetParameter` set for all nodes.

    Args:
        name: Its name.
        default: The value where none was set.
    """

    def __init__(
        self, name: SomeSubstitutionsType, *, default: SomeSubstitutionsType | None = None
    ) -> None:
        self.name = normalize(name)
        self.default = None if default is None else normalize(default)

    def perform(self, context: LaunchContext) -> str:
        """Return the value.

        Raises:
            SubstitutionError: None was set, and there is no default.
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
    """A name that no other launch makes; the same name inside one launch is made once."""

    def __init__(self, name: SomeSubstitutionsType) -> None:
        self.name = normalize(name)

    def perform(self, context: LaunchContext) -> str:
        """Return the name with host, process and a random number."""
        name = perform(context, self.name)
        key = f"anon {name}"
        made: str | None = context.get_locals_as_dict().get(key)
        if made is None:
            host = "".join(c if c.isalnum() else "_" for c in socket.gethostname())
            made = f"{name}_{host}_{os.getpid()}_{secrets.randbelow(2**32)}"
            context.extend_globals({key: made})
        return made


class ThisLaunchFile(Substitution):
    """The path of the launch file that this stands in."""

    _local = "current_launch_file_path"

    def perform(self, context: LaunchContext) -> str:
        """Return the path.

        Raises:
            SubstitutionError: This does not stand in a launch file.
        """
        path: str | None = context.get_locals_as_dict().get(self._local)
        if path is None:
            raise SubstitutionError(f"{self.describe()} stands outside of a launch file")
        return path


class ThisLaunchFileDir(ThisLaunchFile):
    """The folder of the launch file that this stands in."""

    _local = "current_launch_file_directory"


class LaunchLogDir(Substitution):
    """The folder that this launch writes its log files to."""

    def perform(self, context: LaunchContext) -> str:
        """Return the folder."""
        return str(context.journal.folder)


class FileContent(Substitution):
    """What stands in a file."""

    def __init__(self, path: SomeSubstitutionsType) -> None:
        self.path = normalize(path)

    def perform(self, context: LaunchContext) -> str:
        """Return the content.

        Raises:
            SubstitutionError: The file cannot be read.
        """
        path = perform(context, self.path)
        try:
            with open(path, encoding="utf-8") as file:  # noqa: PTH123 - "" is to fail as it does
                return file.read()
        except (OSError, UnicodeDecodeError) as error:
            reason = getattr(error, "strerror", None) or str(error)
            raise SubstitutionError(f"cannot read '{path}': {reason}") from error

    def describe(self) -> str:
        """Return the path."""
        return f"FileContent({describe(self.path)})"
