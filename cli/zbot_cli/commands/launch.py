"""`zbot launch`: runs a launch file until its processes end, or until Ctrl-C."""

from __future__ import annotations

import os
import sys
from functools import partial
from typing import TYPE_CHECKING, Annotated

import typer

import zbot.compat
from zbot.errors import ZbotError
from zbot.errors.suggestion import did_you_mean
from zbot.launch.actions.executable import PREFIX, PREFIX_FILTER
from zbot.launch.actions.include import IncludeLaunchDescription
from zbot.launch.actions.opaque import OpaqueFunction
from zbot.launch.arguments import declared_arguments, parse_arguments
from zbot.launch.description import LaunchDescription, LaunchIntrospector
from zbot.launch.event_handler import OnShutdown
from zbot.launch.service import LaunchService
from zbot.launch.source import AnyLaunchDescriptionSource
from zbot.launch.substitution import TextSubstitution, describe
from zbot.package.rclpy_choice import choose_rclpy
from zbot.package.ros_variables import set_ros_variables
from zbot.package.workspace import set_workspace_variable
from zbot_cli.commands.run.executable_search import find_in_package
from zbot_cli.errors import CommandError
from zbot_cli.output.listing import new_app
from zbot_cli.packages import launch_file
from zbot_cli.packages.executables import NOTED_VARIABLE, note_of_others

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence
    from pathlib import Path

    from zbot.launch.actions.declare_argument import DeclareLaunchArgument
    from zbot.launch.context import LaunchContext

app = new_app("Run a launch file", has_verbs=False)


@app.command()
def launch(
    words: Annotated[
        list[str],
        typer.Argument(
            metavar="[PACKAGE] FILE [NAME:=VALUE]...",
            help="Launch file: a path, a file in a package, or the name of a launch file of zbot",
            show_default=False,
        ),
    ],
    noninteractive: Annotated[
        bool, typer.Option("-n", "--noninteractive", help="Give the processes no terminal as input")
    ] = False,
    debug: Annotated[
        bool, typer.Option("-d", "--debug", help="Show debug messages and tracebacks")
    ] = False,
    print_description: Annotated[
        bool,
        typer.Option(
            "-p", "--print", "--print-description", help="Print the description; launch nothing"
        ),
    ] = False,
    show_args: Annotated[
        bool,
        typer.Option(
            "-s", "--show-args", "--show-arguments", help="Show the arguments of the file"
        ),
    ] = False,
    show_all: Annotated[
        bool,
        typer.Option(
            "-a", "--show-all-subprocesses-output", help="Show all output of all processes"
        ),
    ] = False,
    strict: Annotated[
        bool, typer.Option("--strict", help="Fail if something in the file cannot run here")
    ] = False,
    prefix: Annotated[
        str, typer.Option("--launch-prefix", help="Command to put before every executable")
    ] = "",
    prefix_filter: Annotated[
        str,
        typer.Option(
            "--launch-prefix-filter", help="Regular expression of executables that get the prefix"
        ),
    ] = "",
    genuine: Annotated[
        bool, typer.Option("--genuine", help="Let the nodes use an installed ROS 2 instead of zbot")
    ] = False,
) -> int:
    """Run a launch file."""
    if prefix_filter and not prefix:
        raise CommandError(
            "--launch-prefix must be specified if --launch-prefix-filter is provided"
        )
    # Launch files get zbot's `launch` even if ROS 2's `launch` is installed, because zbot can run
    # only its own objects.
    zbot.compat.install_names({"launch", "launch_ros", "launch_xml", "launch_yaml"})
    path, rest = _find_file(words)
    set_ros_variables()
    if note := choose_rclpy(is_genuine=genuine):
        print(f"note: {note}", file=sys.stderr)
    set_workspace_variable(path.parent)  # launch files and processes import the packages
    arguments = parse_arguments(rest)
    if print_description and arguments:
        print("-p prints the launch file and starts nothing: leave it out", file=sys.stderr)
    if show_args or print_description:
        return _show(path, arguments_only=show_args)
    if show_all:
        os.environ["OVERRIDE_LAUNCH_PROCESS_OUTPUT"] = "both"
    service = LaunchService(
        argv=rest,
        noninteractive=noninteractive or not sys.stdin or not sys.stdin.isatty(),
        debug=debug,
        strict=strict,
        find_program=lambda package, executable: _find(service.context, package, executable),
    )
    options = {PREFIX: prefix, PREFIX_FILTER: prefix_filter}
    service.context.launch_configurations |= {key: value for key, value in options.items() if value}
    source = AnyLaunchDescriptionSource(str(path))
    include = IncludeLaunchDescription(source, launch_arguments=arguments.items())
    include.origin = None  # the command line includes it, not a line of a launch file
    check = partial(_warn_of_typos, service.context, set(arguments))
    service.context.register_event_handler(OnShutdown(on_shutdown=check))  # the launch may fail
    control = OpaqueFunction(function=_let_page_control, args=(path, rest))
    empty = OpaqueFunction(function=_warn_of_nothing, args=(path, source))
    description = LaunchDescription([include, control, empty, OpaqueFunction(function=check)])
    service.include_launch_description(description)
    return service.run() or int(service.context.program_failed)


def _let_page_control(context: LaunchContext, path: Path, arguments: Sequence[str]) -> None:
    from zbot.launch.control.control_server import ControlServer  # noqa: PLC0415 - after the file is read

    ControlServer(context, path, arguments).start()


def _warn_of_nothing(
    context: LaunchContext, path: Path, source: AnyLaunchDescriptionSource
) -> None:
    """Warn if the file returns an empty description, e.g. because it adds no action to it."""
    loaded = source.try_get_launch_description_without_context()
    if loaded is not None and not loaded.entities:
        advice = "put its actions into LaunchDescription([...])"
        context.writer.warning("launch", f"{path} launches nothing: {advice}")


def _find_file(words: Sequence[str]) -> tuple[Path, list[str]]:
    """Find the launch file. The error for a node or for words of a command says what to type."""
    try:
        return launch_file.find(words)
    except ZbotError as error:
        from zbot_cli.commands.wrong_command import advice_for_launch  # noqa: PLC0415 - only for mistakes

        if advice := advice_for_launch(words):
            has_files = error.hint.startswith("it has") and error.hint != "it has none"
            error.hint = f"{error.hint}; to run its node, {advice}" if has_files else advice
        raise


def _find(context: LaunchContext, package: str, executable: str) -> None:
    note = note_of_others(find_in_package(package, executable))
    if note and NOTED_VARIABLE not in context.environment:
        context.writer.warning("launch", note)
        context.environment[NOTED_VARIABLE] = "1"  # the node does not show it again


def _warn_of_typos(context: LaunchContext, arguments: set[str], *_: object) -> None:
    """Log a warning for each undeclared argument that is similar to a declared argument.

    The launch has read its files by now. They are not read before, because a file may need what
    the actions before its include set.
    """
    if context.is_shutdown and not context.failed:
        return  # the user has ended the launch, which may know only some of its arguments
    for name in sorted(arguments - context.declared):
        if hint := did_you_mean(name, context.declared):
            text = f"no launch argument '{name}' is declared; {hint}"
            context.writer.warning("launch", text)
    arguments.clear()


def _show(path: Path, *, arguments_only: bool) -> int:
    description = AnyLaunchDescriptionSource(str(path)).try_get_launch_description_without_context()
    assert description is not None
    if arguments_only:
        print("\n".join(_argument_lines(description, str(path))))
    else:
        print(LaunchIntrospector().format_launch_description(description))
    return 0


def _say_unread(include: IncludeLaunchDescription, error: ZbotError) -> None:
    """Say that the arguments of an included file are not shown, and why."""
    origin = include.origin
    where = f"{origin.path}:{origin.line}: " if origin is not None else ""
    print(f"{where}the arguments of the included file are not shown: {error}", file=sys.stderr)


def _argument_lines(description: LaunchDescription, path: str) -> Iterable[str]:
    found = declared_arguments(description, path=path, report=_say_unread)
    yield "Arguments (pass arguments as '<name>:=<value>'):"
    if not found:
        yield "\n  No arguments."
    for argument in found:
        mark = "*" if argument.conditional else ""
        yield f"\n    '{argument.action.name}'{mark}:\n        {argument.action.description}"
        if argument.action.choices is not None:
            choices = ", ".join(f"'{choice}'" for choice in argument.action.choices)
            yield f"        one of: {choices}"
        if argument.action.default_value is not None:
            yield f"        (default: {_default(argument.action)})"
    if any(argument.conditional for argument in found):
        yield "\n* argument(s) which are only used if specific conditions occur"


def _default(action: DeclareLaunchArgument) -> str:
    assert action.default_value is not None
    if all(isinstance(part, TextSubstitution) for part in action.default_value):
        return (
            f"'{''.join(p.text for p in action.default_value if isinstance(p, TextSubstitution))}'"
        )
    return describe(action.default_value)
