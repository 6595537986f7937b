"""Processes as actions."""

from __future__ import annotations

import os
import shlex
from typing import TYPE_CHECKING, Any, Final

from zbot.launch.action import Action
from zbot.launch.actions.event_action import Shutdown
from zbot.launch.actions.executable import Executable, Prepared, Variable
from zbot.launch.errors import EntityTypeError, ProgramError
from zbot.launch.event_handler import OnProcessExit
from zbot.launch.own_command import find_on_path
from zbot.launch.sink import DEFAULT, parse_output
from zbot.launch.substitution import normalize, perform, to_bool
from zbot.launch.supervisor import Policy, Supervisor

if TYPE_CHECKING:
    import asyncio
    from collections.abc import Iterable, Mapping, Sequence

    from zbot.launch.context import LaunchContext
    from zbot.launch.entity import LaunchDescriptionEntity
    from zbot.launch.event_handler import Reaction
    from zbot.launch.frontend.entity import Entity
    from zbot.launch.frontend.parser import Parser
    from zbot.launch.substitution import SomeSubstitutionsType, Substitution

_OVERRIDE: Final = "OVERRIDE_LAUNCH_PROCESS_OUTPUT"
_LINE: Final = "[{label}] {line}"


class ExecuteLocal(Action):
    """Run a program.

    Args:
        process_description: Its command line and surroundings.
        shell: Whether the command line is for the shell.
        sigterm_timeout: Seconds after SIGINT at which it gets SIGTERM.
        sigkill_timeout: Seconds after that at which it gets SIGKILL.
        emulate_tty: Whether it is to believe that it writes to a terminal.
        output: Where its output goes: `screen`, `log`, `both`, `own_log`, `full`.
        output_format: How a line looks: a text with `{line}`.
        cached_output: Whether `get_stdout` and `get_stderr` return what it wrote.
        log_cmd: Whether its command line is shown.
        on_exit: What to do when it ends.
        respawn: Whether to start it again when it ends.
        respawn_delay: Seconds to wait before that.
        respawn_max_retries: How often; without end if negative.
    """

    def __init__(
        self,
        *,
        process_description: Executable,
        shell: bool = False,
        sigterm_timeout: Any = 5,
        sigkill_timeout: Any = 5,
        emulate_tty: bool | SomeSubstitutionsType = False,
        output: SomeSubstitutionsType | Mapping[str, Any] | None = None,
        output_format: str = _LINE,
        cached_output: bool = False,
        log_cmd: bool = False,
        on_exit: Reaction | str = None,
        respawn: bool | SomeSubstitutionsType = False,
        respawn_delay: Any = 0.0,
        respawn_max_retries: int = -1,
        **options: Any,
    ) -> None:
        super().__init__(**options)
        self.process_description = process_description
        self.shell = shell
        self.sigterm_timeout, self.sigkill_timeout = _text(sigterm_timeout), _text(sigkill_timeout)
        self.emulate_tty, self.output = emulate_tty, output
        # ROS 2's own default is an expression about the action; it means what `_LINE` does.
        self.output_format = _LINE if "{this" in output_format else output_format
        self.cached_output, self.log_cmd = cached_output, log_cmd
        is_shutdown = on_exit == "shutdown"  # as XML and YAML write it
        self.on_exit: Any = [Shutdown(reason="process ended")] if is_shutdown else on_exit
        self.respawn, self.respawn_delay = _text(respawn), _text(respawn_delay or 0.0)
        self.respawn_max_retries = respawn_max_retries
        self.process_details: dict[str, Any] = {}
        self.return_code: int | None = None
        self._kept: dict[int, list[bytes]] = {1: [], 2: []}
        self._task: asyncio.Task[None] | None = None

    @property
    def name(self) -> Any:
        """The process's name, `talker-1`, once it is started; before, as it was given."""
        return self.process_details.get("name") or self.process_description.name

    @property
    def cmd(self) -> Any:
        """The words of the command line."""
        return self.process_description.cmd

    @property
    def cwd(self) -> list[Substitution] | None:
        """The folder to run it in."""
        return self.process_description.cwd

    @property
    def env(self) -> list[Variable] | None:
        """Its whole environment."""
        return self.process_description.env

    @property
    def additional_env(self) -> list[Variable] | None:
        """What is added to its environment."""
        return self.process_description.additional_env

    def prepare(self, context: LaunchContext) -> Prepared:
        """Return the command line.

        Raises:
            ProgramError: There is nothing in it.
        """
        description = self.process_description
        words = [perform(context, word) for word in description.cmd]
        if not "".join(words).strip():
            raise ProgramError("the command to execute is empty")
        first = words[0].split()[0] if self.shell else words[0]
        name = perform(context, description.name) if description.name else _base_name(first)
        return description.prepare(context, words, name)

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the actions that are done when it ends, unless a function says which."""
        return list(self.on_exit) if isinstance(self.on_exit, (list, tuple)) else []

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        """Start the program, unless the launch is ending.

        Raises:
            ProgramError: There is no such program.
        """
        if context.is_shutdown:
            return None
        prepared = self.prepare(context)
        if not self.shell:
            _check(prepared)
        supervisor = Supervisor(self, context, prepared, self._policy(context))
        if self.on_exit is not None:
            handler = OnProcessExit(target_action=self, on_exit=self.on_exit)
            context.register_event_handler(handler)
        self.process_details = supervisor.details()
        self._task = supervisor.start()
        return None

    def _policy(self, context: LaunchContext) -> Policy:
        return Policy(
            shell=self.shell,
            has_terminal=_truth("emulate_tty", self.emulate_tty, context),
            sinks=self._sinks(context),
            form=self.output_format,
            sigterm_timeout_s=_number("sigterm_timeout", self.sigterm_timeout, context),
            sigkill_timeout_s=_number("sigkill_timeout", self.sigkill_timeout, context),
            respawn=_truth("respawn", self.respawn, context),
            respawn_delay_s=_number("respawn_delay", self.respawn_delay, context),
            respawn_max_retries=self.respawn_max_retries,
            shows_command=self.log_cmd,
        )

    def _sinks(self, context: LaunchContext) -> dict[str, frozenset[str]]:
        forced = context.environment.get(_OVERRIDE, "")
        output: Any = forced or (DEFAULT if self.output is None else self.output)
        return parse_output(output if hasattr(output, "items") else perform(context, output))

    def keep_output(self, fd: int, data: bytes) -> None:
        """Remember what it wrote, if that is wanted."""
        if self.cached_output:
            self._kept[fd].append(data)

    def get_stdout(self) -> bytes:
        """Return what it wrote to stdout; empty without `cached_output`."""
        return b"".join(self._kept[1])

    def get_stderr(self) -> bytes:
        """Return what it wrote to stderr; empty without `cached_output`."""
        return b"".join(self._kept[2])

    def get_asyncio_future(self) -> asyncio.Task[None] | None:
        """Return a future that is done when the program has ended for good."""
        return self._task

    def describe(self) -> str:
        """Return the command line."""
        return f"{type(self).__name__}({self.process_description.describe()})"


class ExecuteProcess(ExecuteLocal):
    """Run a program.

    Args:
        cmd: The words of its command line.
        prefix: Words to put before them.
        name: What the process is called.
        cwd: The folder to run it in.
        env: Its whole environment.
        additional_env: What to add to its environment.
        options: As for `ExecuteLocal`.
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
        **options: Any,
    ) -> None:
        executable = Executable(
            cmd=cmd, prefix=prefix, name=name, cwd=cwd, env=env, additional_env=additional_env
        )
        super().__init__(process_description=executable, **options)

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:
        """Return the class and the options that a tag with a command line stands for."""
        from zbot.launch.frontend.tags import executable_options  # noqa: PLC0415 - cycle

        return cls, executable_options(entity, parser)

    @classmethod
    def _parse_cmdline(cls, cmd: str, parser: Parser) -> list[list[Substitution]]:
        """Return the words of a command line; extensions call this by its name in launch."""
        from zbot.launch.frontend.tags import words  # noqa: PLC0415 - cycle

        return words(parser.parse_substitution(cmd))


def _check(prepared: Prepared) -> None:
    cwd, program = prepared.cwd, prepared.words[0]
    if cwd is not None and not os.path.isdir(cwd):  # noqa: PTH112 - "" is no folder
        raise ProgramError(f"the folder '{cwd}' to run '{prepared.name}' in is not there")
    here = os.path.join(cwd or "", program)  # noqa: PTH118 - a path is relative to that folder
    if find_on_path(program, prepared.env) is None and not os.access(here, os.X_OK):
        hint = "with shell=True the words are a line for the shell" if " " in program else ""
        raise ProgramError(f"executable '{program}' not found on the PATH", hint)


def _base_name(program: str) -> str:
    return os.path.basename(shlex.split(program)[0] if '"' in program else program)  # noqa: PTH119


def _text(value: Any) -> Any:
    return normalize(str(value) if isinstance(value, (bool, int, float)) else value)


def _truth(what: str, value: Any, context: LaunchContext) -> bool:
    text = perform(context, _text(value))
    truth = to_bool(text)
    if truth is None:
        raise EntityTypeError(what, "true or false", text)
    return truth


def _number(what: str, value: Any, context: LaunchContext) -> float:
    text = perform(context, value)
    try:
        return float(text)
    except ValueError:
        raise EntityTypeError(what, "a number of seconds", text) from None
