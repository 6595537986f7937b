"""Command line of a program before and after substitution, with its directory and environment."""

from __future__ import annotations

import errno
import os
import re
import shlex
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeAlias

from zbot.launch.errors import ProgramError
from zbot.launch.substitution import describe_list, normalize, perform
from zbot.package.zbot_command import (
    add_ros2_to_path,
    find_on_path,
    run_scripts_with_zbot,
    zbot_command,
)

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from zbot.launch.context import LaunchContext
    from zbot.launch.substitution import SomeSubstitutionsType, Substitution

#: The name and the value of an environment variable.
Variable: TypeAlias = "tuple[list[Substitution], list[Substitution]]"

#: Names of the launch configurations that `zbot launch` sets from its options.
PREFIX, PREFIX_FILTER = "launch-prefix", "launch-prefix-filter"


@dataclass(frozen=True)
class Prepared:
    """A command line after substitution, ready to start."""

    words: list[str]
    name: str  #: name of the process, such as `talker`
    cwd: str | None
    env: dict[str, str]


def check_program(prepared: Prepared) -> None:
    """Check that the program and the working directory of a command line exist.

    Raises:
        ProgramError: One of them does not exist, or the program is not executable.
    """
    cwd, program = prepared.cwd, prepared.words[0]
    if cwd is not None and not os.path.isdir(cwd):  # noqa: PTH112 - "" is not a folder
        raise ProgramError(f"the working directory '{cwd}' of '{prepared.name}' does not exist")
    here = os.path.join(cwd or "", program)  # noqa: PTH118 - a relative path starts in cwd
    if find_on_path(program, prepared.env) is not None or os.access(here, os.X_OK):
        return
    if os.path.isfile(here):  # noqa: PTH113 - as above
        raise ProgramError(f"'{program}' is not executable", f"type: chmod +x {shlex.quote(here)}")
    hint = "with shell=True a shell splits the command line into words" if " " in program else ""
    raise ProgramError(f"executable '{program}' not found on the PATH", hint)


def not_started(prepared: Prepared, error: OSError) -> ProgramError:
    """Return the error for a program that exists but that the system did not start."""
    program = prepared.words[0]
    first = _first_line(os.path.join(prepared.cwd or "", program))  # noqa: PTH118 - as above
    if first.startswith("#!") and isinstance(error, FileNotFoundError):
        reason = f"the program in its first line, {first}, does not exist"
    elif isinstance(error, OSError) and error.errno == errno.ENOEXEC and not first.startswith("#!"):
        reason = "it is no program of this machine, and its first line does not begin with #!"
    else:
        reason = error.strerror or str(error)
    return ProgramError(f"cannot start '{program}': {reason}")


def _first_line(path: str) -> str:
    try:
        with open(path, encoding="utf-8", errors="replace") as file:  # noqa: PTH123 - as above
            return file.readline(200).strip()
    except (OSError, ValueError):
        return ""


class Executable:
    """A command line before substitution.

    Args:
        cmd: The words.
        prefix: Words to put before the words of `cmd`.
        name: The name of the process. None means the name of the program.
        cwd: The working directory.
        env: The whole environment. None means the environment of the launch.
        additional_env: Variables to add to the environment.
        arguments: Words to add at the end.
    """

    def __init__(
        self,
        *,
        cmd: Iterable[SomeSubstitutionsType] | SomeSubstitutionsType,
        prefix: SomeSubstitutionsType | None = None,
        name: SomeSubstitutionsType | None = None,
        cwd: SomeSubstitutionsType | None = None,
        env: Mapping[Any, SomeSubstitutionsType] | None = None,
        additional_env: Mapping[Any, SomeSubstitutionsType] | None = None,
        arguments: Iterable[SomeSubstitutionsType] | None = None,
    ) -> None:
        given: Any = cmd
        words = given if isinstance(given, (list, tuple)) else [given]
        self.cmd = [normalize(word) for word in words]
        self.cmd += [normalize(word) for word in arguments or ()]
        self.prefix = _optional(prefix)
        self.name, self.cwd = _optional(name), _optional(cwd)
        self.env, self.additional_env = _variables(env), _variables(additional_env)
        self.final_cmd: list[str] | None = None
        self.final_cwd: str | None = None
        self.final_env: dict[str, str] | None = None
        self.final_name: str | None = None

    def apply_context(self, context: LaunchContext) -> None:
        """Perform the substitutions and set `final_cmd`, `final_cwd`, `final_env`, `final_name`."""
        words = [perform(context, word) for word in self.cmd]
        name = perform(context, self.name) if self.name else os.path.basename(words[0])  # noqa: PTH119
        prepared = self.prepare(context, words, name)
        self.final_cmd, self.final_cwd = prepared.words, prepared.cwd
        self.final_env, self.final_name = prepared.env, prepared.name

    def describe(self) -> str:
        """Return a text with the words of `cmd`."""
        return f"cmd={describe_list(self.cmd)}"

    def prepare(
        self, context: LaunchContext, words: Sequence[str], name: str, *, is_shell: bool = False
    ) -> Prepared:
        """Return the command line, including its prefix, with working directory and environment.

        Args:
            context: The context for substitutions.
            words: The words of `cmd`. For a shell, one of them may be a part of a command line.
            name: The name of the process.
            is_shell: Whether a shell runs the command line.
        """
        own_prefix = perform(context, self.prefix) if self.prefix else ""
        prefix = own_prefix or _common_prefix(context, name)
        cwd = perform(context, self.cwd) if self.cwd else None
        own = _shell_words(words) if is_shell else run_scripts_with_zbot(words)
        line = [*shlex.split(prefix, posix=os.name != "nt"), *own]
        return Prepared(line, name, cwd, self._environment(context))

    def _environment(self, context: LaunchContext) -> dict[str, str]:
        base = context.environment if self.env is None else _performed(context, self.env)
        own = {"PYTHONUNBUFFERED": "1"}
        if context.writer.is_coloured:
            own["RCUTILS_COLORIZED_OUTPUT"] = "1"
        added = _performed(context, self.additional_env or ())
        return add_ros2_to_path({**own, **base, **added})


def _shell_words(words: Sequence[str]) -> list[str]:
    """Return the words for a shell. The first may be a whole command line, e.g. `gz sim -r`."""
    parts = [*words[0].lstrip().split(" ", 1), *words[1:]]
    line = run_scripts_with_zbot(parts)
    if line == parts:
        return list(words)
    start = len(zbot_command())
    return [*map(_quoted, line[:start]), *line[start:]]


def _quoted(word: str) -> str:
    return f'"{word}"' if os.name == "nt" else shlex.quote(word)


def _optional(value: SomeSubstitutionsType | None) -> list[Substitution] | None:
    return None if value is None else normalize(value)


def _variables(given: Mapping[Any, SomeSubstitutionsType] | None) -> list[Variable] | None:
    if given is None:
        return None
    return [(normalize(name), normalize(value)) for name, value in given.items()]


def _performed(context: LaunchContext, variables: Iterable[Variable]) -> dict[str, str]:
    return {perform(context, name): perform(context, value) for name, value in variables}


def _common_prefix(context: LaunchContext, name: str) -> str:
    prefix = str(context.launch_configurations.get(PREFIX, ""))
    pattern = context.launch_configurations.get(PREFIX_FILTER)
    return prefix if pattern is None or re.match(str(pattern), name) else ""
