"""Actions that run a program as a process."""

from __future__ import annotations

import os
import shlex
from typing import TYPE_CHECKING, Any, Final, cast

from zbot.launch.action import Action
from zbot.launch.actions.event_action import Shutdown
from zbot.launch.actions.executable import Executable, Prepared, Variable
from zbot.launch.entity import LaunchDescriptionEntity
from zbot.launch.errors import EntityTypeError, ProgramError
from zbot.launch.event_handler import OnProcessExit
from zbot.launch.process_event import ProcessExited, ProcessStarted
from zbot.launch.sink import DEFAULT, parse_output
from zbot.launch.substitution import Substitution, normalize, perform, to_bool
from zbot.launch.supervisor import Policy, Supervisor
from zbot.package.errors import NotRunnableError
from zbot.package.unavailable import ends_by_itself, unavailable_program
from zbot.package.zbot_command import find_on_path

if TYPE_CHECKING:
    import asyncio
    from collections.abc import Iterable, Mapping, Sequence

    from zbot.launch.context import LaunchContext
    from zbot.launch.event_handler import Reaction
    from zbot.launch.frontend.entity import Entity
    from zbot.launch.frontend.parser import Parser
    from zbot.launch.substitution import SomeSubstitutionsType

_OVERRIDE: Final = "OVERRIDE_LAUNCH_PROCESS_OUTPUT"
_SHUTDOWN: Final = "shutdown"  # the text of `on_exit` in XML and YAML
_LINE: Final = "[{label}] {line}"


class ExecuteLocal(Action):
    """Run a program.

    Args:
        process_description: The command line, working directory and environment.
        shell: Whether a shell runs the command line.
        sigterm_timeout: Seconds from SIGINT to SIGTERM.
        sigkill_timeout: Seconds from SIGTERM to SIGKILL.
        emulate_tty: Whether stdout and stderr are pseudo terminals.
        output: Where the output goes, e.g. `screen`, `log`, `both`, `own_log`, `full` or `none`.
        output_format: Format of a line. It contains `{line}`, and may contain `{label}`.
        cached_output: Whether `get_stdout` and `get_stderr` return the output.
        log_cmd: Whether to log the command line.
        on_exit: Actions, or a function that returns actions, for the end of the process. Texts and
            substitutions are also possible. The text `shutdown` ends the launch, and an empty text
            has no effect.
        respawn: Whether to start the program again when it ends.
        respawn_delay: Seconds to wait before the program starts again.
        respawn_max_retries: The maximum number of restarts. A negative number means no limit.
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
        on_exit: Reaction | SomeSubstitutionsType = None,
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
        # ROS 2's default format contains `{this...}`. Lines with that format look as with `_LINE`.
        self.output_format = _LINE if "{this" in output_format else output_format
        self.cached_output, self.log_cmd = cached_output, log_cmd
        self.on_exit: Any = on_exit
        self.respawn, self.respawn_delay = _text(respawn), _text(respawn_delay or 0.0)
        self.respawn_max_retries = respawn_max_retries
        self.process_details: dict[str, Any] = {}
        self.return_code: int | None = None
        self._cached: dict[int, list[bytes]] = {1: [], 2: []}
        self._task: asyncio.Task[None] | None = None
        self._supervisor: Supervisor | None = None

    @property
    def name(self) -> Any:
        """The process's label, e.g. `talker-1`. Before the start, this is the given name."""
        return self.process_details.get("name") or self.process_description.name

    @property
    def cmd(self) -> Any:
        """The words of the command line."""
        return self.process_description.cmd

    @property
    def cwd(self) -> list[Substitution] | None:
        """The working directory."""
        return self.process_description.cwd

    @property
    def env(self) -> list[Variable] | None:
        """The whole environment. None means the environment of the launch."""
        return self.process_description.env

    @property
    def additional_env(self) -> list[Variable] | None:
        """The variables that are added to the environment."""
        return self.process_description.additional_env

    def prepare(self, context: LaunchContext) -> Prepared:
        """Return the command line after substitution.

        Raises:
            ProgramError: The command line is empty.
        """
        description = self.process_description
        words = [perform(context, word) for word in description.cmd]
        if not "".join(words).strip():
            raise ProgramError("the command to execute is empty")
        first = words[0].split()[0] if self.shell else words[0]
        name = perform(context, description.name) if description.name else _base_name(first)
        return description.prepare(context, words, name, is_shell=self.shell)

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the actions of `on_exit`. The list is empty if `on_exit` is a function."""
        parts = self.on_exit if isinstance(self.on_exit, (list, tuple)) else ()
        return [part for part in parts if isinstance(part, LaunchDescriptionEntity)]

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        """Start the program, unless the launch is ending.

        As in ROS 2, an error is logged if the program cannot be started, and the launch goes on.

        Raises:
            NotRunnableError: The program is well known and does not run in zbot.
            ProgramError: The command line is empty.
            EntityTypeError: A text in `on_exit` is neither `shutdown` nor empty.
        """
        if context.is_shutdown:
            return None
        try:
            prepared = self.prepare(context)
            _check_known(prepared, is_shell=self.shell)
        except NotRunnableError:
            self._skip(context)
            raise
        supervisor = self._supervisor = Supervisor(self, context, prepared, self._policy(context))
        reaction = _reaction(self.on_exit, context)
        if reaction is not None:
            context.register_event_handler(OnProcessExit(target_action=self, on_exit=reaction))
        self.process_details = supervisor.details()
        self._task = supervisor.start()
        return None

    def restart(self) -> None:
        """Stop the program and start it again. If it has ended, only start it.

        `on_exit` is not executed when a running program stops for this.
        """
        if self._supervisor is not None:
            self._task = self._supervisor.restart()

    def _skip(self, context: LaunchContext) -> None:
        """Emit events for the start and exit of a left-out program, if it normally ends soon.

        So the actions that wait for the end of this program are still executed.
        """
        words = [perform(context, word) for word in self.process_description.cmd[:1]]
        if not words or not ends_by_itself(words[0]):
            return
        reaction = _reaction(self.on_exit, context)
        if reaction is not None:
            context.register_event_handler(OnProcessExit(target_action=self, on_exit=reaction))
        process: dict[str, Any] = {"action": self, "name": words[0], "cmd": words}
        process |= {"cwd": None, "env": None}
        context.emit_event_sync(ProcessStarted(**process, pid=0))
        context.emit_event_sync(ProcessExited(**process, pid=0))

    def _policy(self, context: LaunchContext) -> Policy:
        return Policy(
            shell=self.shell,
            has_terminal=_boolean("emulate_tty", self.emulate_tty, context),
            sinks=self._sinks(context),
            line_format=self.output_format,
            sigterm_timeout_s=_number("sigterm_timeout", self.sigterm_timeout, context),
            sigkill_timeout_s=_number("sigkill_timeout", self.sigkill_timeout, context),
            respawn=_boolean("respawn", self.respawn, context),
            respawn_delay_s=_number("respawn_delay", self.respawn_delay, context),
            respawn_max_retries=self.respawn_max_retries,
            shows_command=self.log_cmd,
        )

    def _sinks(self, context: LaunchContext) -> dict[str, frozenset[str]]:
        forced = context.environment.get(_OVERRIDE, "")
        output: Any = forced or (DEFAULT if self.output is None else self.output)
        return parse_output(output if hasattr(output, "items") else perform(context, output))

    def keep_output(self, fd: int, data: bytes) -> None:
        """Store output of the process if `cached_output` is set."""
        if self.cached_output:
            self._cached[fd].append(data)

    def get_stdout(self) -> bytes:
        """Return the bytes of stdout, or empty bytes without `cached_output`."""
        return b"".join(self._cached[1])

    def get_stderr(self) -> bytes:
        """Return the bytes of stderr, or empty bytes without `cached_output`."""
        return b"".join(self._cached[2])

    def get_asyncio_future(self) -> asyncio.Task[None] | None:
        """Return a task that is done when the program has ended and is not started again."""
        return self._task

    def describe(self) -> str:
        """Return the command line."""
        return f"{type(self).__name__}({self.process_description.describe()})"


class ExecuteProcess(ExecuteLocal):
    """Run a program.

    Args:
        cmd: The words of the command line.
        prefix: Words to put before the words of `cmd`.
        name: The name of the process. None means the name of the program.
        cwd: The working directory.
        env: The whole environment. None means the environment of the launch.
        additional_env: Variables to add to the environment.
        options: The options of `ExecuteLocal`.
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
        """Return the class and the constructor options for an `executable` tag."""
        from zbot.launch.frontend.tags import executable_options  # noqa: PLC0415 - cycle

        return cls, executable_options(entity, parser)

    @classmethod
    def _parse_cmdline(cls, cmd: str, parser: Parser) -> list[list[Substitution]]:
        """Return the words of a command line. Extensions of launch call this private method."""
        from zbot.launch.frontend.tags import words  # noqa: PLC0415 - cycle

        return words(parser.parse_substitution(cmd))


def _reaction(given: Any, context: LaunchContext) -> Reaction:
    """Return `on_exit`, in which actions replace the texts and substitutions."""
    if given is None or callable(given) or isinstance(given, LaunchDescriptionEntity):
        return cast("Reaction", given)
    parts = [given] if isinstance(given, (str, Substitution)) else given
    return [entity for part in parts for entity in _exit_actions(part, context)]


def _exit_actions(part: Any, context: LaunchContext) -> list[LaunchDescriptionEntity]:
    if not isinstance(part, (str, Substitution)):
        return [] if part is None else [part]
    word = perform(context, part)
    if word not in {_SHUTDOWN, ""}:
        raise EntityTypeError("on_exit", f"an action, '{_SHUTDOWN}' or an empty text", word)
    return [Shutdown(reason="process ended")] if word else []


def _check_known(prepared: Prepared, *, is_shell: bool) -> None:
    program = prepared.words[0].split()[0] if is_shell else prepared.words[0]
    kind = unavailable_program(program)
    if kind is not None and find_on_path(program, prepared.env) is None:
        raise NotRunnableError(program, kind)


def _base_name(program: str) -> str:
    return os.path.basename(shlex.split(program)[0] if '"' in program else program)  # noqa: PTH119


def _text(value: Any) -> Any:
    return normalize(str(value) if isinstance(value, (bool, int, float)) else value)


def _boolean(what: str, value: Any, context: LaunchContext) -> bool:
    text = perform(context, _text(value))
    boolean = to_bool(text)
    if boolean is None:
        raise EntityTypeError(what, "true or false", text)
    return boolean


def _number(what: str, value: Any, context: LaunchContext) -> float:
    text = perform(context, value)
    try:
        return float(text)
    except ValueError:
        raise EntityTypeError(what, "a number of seconds", text) from None
