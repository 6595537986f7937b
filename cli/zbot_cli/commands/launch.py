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
from zbot.launch.arguments import declared_arguments, parse_arguments
from zbot.launch.description import LaunchDescription
from zbot.launch.introspector import LaunchIntrospector
from zbot.launch.left_out import leave_out
from zbot.launch.service import LaunchService
from zbot.launch.source import AnyLaunchDescriptionSource
from zbot.launch.substitution import TextSubstitution, describe
from zbot.package.absent import absent_packages_reported
from zbot.package.ros_variables import set_ros_variables
from zbot.package.workspace import set_workspace_variable
from zbot_cli.commands.run import find as find_executable
from zbot_cli.errors import CommandError
from zbot_cli.output.listing import new_app
from zbot_cli.packages import launch_file
from zbot_cli.packages.executables import NOTED_VARIABLE, note_of_others

if TYPE_CHECKING:
    from collections.abc import Iterable
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
) -> int:
    """Run a launch file."""
    if prefix_filter and not prefix:
        raise CommandError(
            "--launch-prefix must be specified if --launch-prefix-filter is provided"
        )
    # Launch files get zbot's `launch` even if ROS 2's `launch` is installed, because zbot can run
    # only its own objects.
    zbot.compat.install_names({"launch", "launch_ros", "launch_xml", "launch_yaml"})
    path, rest = launch_file.find(words)
    set_ros_variables()
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
    service.context.launch_configurations |= {key: one for key, one in options.items() if one}
    source = AnyLaunchDescriptionSource(str(path))
    with absent_packages_reported(partial(leave_out, service.context)):
        for text in _likely_typos(source, path, arguments):
            service.context.writer.warning("launch", text)
    include = IncludeLaunchDescription(source, launch_arguments=arguments.items())
    include.origin = None  # the command line includes it, not a line of a launch file
    service.include_launch_description(LaunchDescription([include]))
    return service.run() or int(service.context.program_failed)


def _find(context: LaunchContext, package: str, executable: str) -> None:
    found, _ = find_executable([package, executable])
    note = note_of_others(found)
    if note and NOTED_VARIABLE not in context.environment:
        context.writer.warning("launch", note)
        context.environment[NOTED_VARIABLE] = "1"  # the node does not show it again


def _likely_typos(
    source: AnyLaunchDescriptionSource, path: Path, arguments: Iterable[str]
) -> Iterable[str]:
    """Yield a warning for each undeclared argument that is similar to a declared argument."""
    if not arguments:
        return
    try:
        description = source.try_get_launch_description_without_context()
    except ZbotError:
        return  # the launch reports the error
    found = () if description is None else declared_arguments(description, path=str(path))
    known = {one.action.name for one in found}
    for name in set(arguments) - known:
        hint = did_you_mean(name, known)
        if hint:
            yield f"no launch argument '{name}' is declared; {hint}"


def _show(path: Path, *, arguments_only: bool) -> int:
    description = AnyLaunchDescriptionSource(str(path)).try_get_launch_description_without_context()
    assert description is not None
    if arguments_only:
        print("\n".join(_argument_lines(description, str(path))))
    else:
        print(LaunchIntrospector().format_launch_description(description))
    return 0


def _argument_lines(description: LaunchDescription, path: str) -> Iterable[str]:
    found = declared_arguments(description, path=path)
    yield "Arguments (pass arguments as '<name>:=<value>'):"
    if not found:
        yield "\n  No arguments."
    for one in found:
        mark = "*" if one.conditional else ""
        yield f"\n    '{one.action.name}'{mark}:\n        {one.action.description}"
        if one.action.choices is not None:
            choices = ", ".join(f"'{choice}'" for choice in one.action.choices)
            yield f"        one of: {choices}"
        if one.action.default_value is not None:
            yield f"        (default: {_default(one.action)})"
    if any(one.conditional for one in found):
        yield "\n* argument(s) which are only used if specific conditions occur"


def _default(action: DeclareLaunchArgument) -> str:
    assert action.default_value is not None
    if all(isinstance(part, TextSubstitution) for part in action.default_value):
        return (
            f"'{''.join(p.text for p in action.default_value if isinstance(p, TextSubstitution))}'"
        )
    return describe(action.default_value)
