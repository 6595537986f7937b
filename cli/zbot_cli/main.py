"""Entry point of the `zbot` command: it runs a command line, and prints errors.

In `zbot topic list`, the word `topic` is the noun, and `list` is the verb. Only the module of the
noun is imported, so that commands start fast.
"""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING, Any, NoReturn

from zbot_cli.input import keyboard_interrupt
from zbot_cli.output import standard_streams
from zbot_cli.output.exit_status import Status

if TYPE_CHECKING:
    from collections.abc import Callable

#: All nouns. Each has the line that `zbot --help` shows for it.
NOUNS = {
    "action": "Look at actions and send goals",
    "bag": "Record topics, and play recordings",
    "bridge": "Connect zbot with ROS 2",
    "build": "Check packages; nothing needs building",
    "class": "Start and manage a class",
    "completion": "Complete words in your shell with Tab",
    "control": "Look at controllers and change their states",
    "daemon": "Say that no daemon is needed",
    "doctor": "Check this machine and the domain for problems",
    "foxglove": "Show the running system in Foxglove or Lichtblick",
    "graph": "Show which nodes talk to each other",
    "hub": "Link other machines to this one",
    "interface": "Look at message, service and action types",
    "join": "Join a class or another machine",
    "launch": "Run a launch file",
    "leave": "Leave the class or the other machine",
    "lifecycle": "Look at managed nodes and change their states",
    "mqtt": "Connect an MQTT broker of a smart home",
    "node": "Look at nodes",
    "param": "Look at parameters and set them",
    "pkg": "Find and create packages",
    "plot": "Plot numeric fields of topics",
    "run": "Run a node",
    "security": "Make certificates for machines",
    "serial": "Connect a board on a USB cable",
    "service": "Look at services and call them",
    "setup-shell": "Make ros2, colcon and rqt_graph run zbot",
    "share": "Let one student read another's topics",
    "sim": "Simulate robots in a world",
    "status": "Show the class or the other machine",
    "test": "Run tests, also those of launch files",
    "topic": "Look at topics, print and publish messages",
    "view": "Show the robot in 3D in a browser",
    "web": "Show the running system in a browser",
}
_ALIASES = {"wtf": "doctor"}
_HIDDEN = {"complete"}
#: Nouns that run the user's own programs in this process.
_RUNS_PROGRAMS = {"launch", "run", "test"}
#: Nouns that use an installed ROS 2 in this process. All others use only zbot's messages.
_USES_ROS2 = {"bridge", "class"}
#: Commands of ROS 2 that zbot does not have, and what to type instead.
_ELSEWHERE = {
    "catkin_make": "zbot needs no catkin_make: type 'zbot build' to check the packages.",
    "colcon": "Type 'zbot build' instead of 'colcon build', and 'zbot test' for 'colcon test'.",
    "component": "zbot has no components: run each node with 'zbot run', or use a launch file.",
    "multicast": "zbot needs no multicast: type 'zbot doctor' to check the network.",
    "ros2": "Leave out 'ros2': type 'zbot topic list' instead of 'ros2 topic list'.",
    "rosbag": "Type 'zbot bag' instead of 'rosbag'.",
    "roscore": "zbot needs no roscore: run a node, e.g. 'zbot run sensor'.",
    "rosdep": "zbot needs no rosdep: install Python packages with 'python -m pip install NAME'.",
    "roslaunch": "Type 'zbot launch' instead of 'roslaunch'.",
    "rosmsg": "Type 'zbot interface' instead of 'rosmsg'.",
    "rosnode": "Type 'zbot node' instead of 'rosnode'.",
    "rosparam": "Type 'zbot param' instead of 'rosparam'.",
    "rosrun": "Type 'zbot run' instead of 'rosrun'.",
    "rosservice": "Type 'zbot service' instead of 'rosservice'.",
    "rostopic": "Type 'zbot topic' instead of 'rostopic'.",
    "rqt": "Type 'zbot web' to see the running system in a browser.",
    "rqt_console": "Type 'zbot web console' to see log lines in a browser.",
    "rqt_graph": "Type 'zbot web graph' for a picture in a browser, or 'zbot graph' for text.",
    "rqt_plot": "Type 'zbot plot TOPIC' to plot the numbers of a topic.",
    "rviz2": "Type 'zbot view' to see the robot in 3D in a browser.",
}


def _version() -> str:
    import platform  # noqa: PLC0415 - needed only for --version
    from importlib.metadata import version  # noqa: PLC0415 - needed only for --version

    from zbot.version import __version__  # noqa: PLC0415 - needed only for --version

    return (
        f"zbot {__version__} (eclipse-zenoh {version('eclipse-zenoh')}, "
        f"Python {platform.python_version()}, {platform.system()} {platform.machine()})"
    )


def help_text() -> str:
    """Return what `zbot --help` prints."""
    width = max(map(len, NOUNS))
    nouns = "\n".join(f"  {noun:<{width}}  {text}" for noun, text in NOUNS.items())
    return f"""\
Usage: zbot [OPTIONS] COMMAND [ARGS]...

  Robots in Python: nodes, topics, services and actions in the words of ROS 2.

Options:
  --domain N     Use this domain, also if the machine has joined a class
  --config FILE  Zenoh configuration for this command [env: ZBOT_CONFIG]
  --rmw          Speak ROS 2's rmw_zenoh_cpp; may follow COMMAND [env: RMW_IMPLEMENTATION]
  --debug        Show where an error comes from
  --version      Print the versions of zbot, Zenoh and Python
  -h, --help     Print this text

Commands:
{nouns}

  `zbot COMMAND --help` shows the options of a command."""


class _Options:
    """Options before the noun."""

    def __init__(self, words: list[str]) -> None:
        self.debug = False
        self.domain = ""
        self.rmw = ""
        self.words = words
        while self.words and self.words[0].startswith("-"):
            self._read(self.words.pop(0))

    def _read(self, word: str) -> None:
        option, _, value = word.partition("=")
        if option == "--debug":
            self.debug = True
        elif option == "--version":
            _print_and_exit(_version())
        elif option in {"-h", "--help"}:
            _print_and_exit(help_text())
        elif option == "--config":
            os.environ["ZBOT_CONFIG"] = self._value(option, value, "a file")
        elif option == "--rmw":
            self.rmw = word
        elif option == "--domain":
            self.domain = self._value(option, value, "a number")
        else:
            _exit_with_usage_error(f"No such option: {option}")

    def _value(self, option: str, value: str, what: str) -> str:
        if not value and not self.words:
            _exit_with_usage_error(f"Option '{option}' requires {what}.")
        return value or self.words.pop(0)


def _use_domain(text: str) -> None:
    """Set the domain of this command. In a class, print a note if the domain is another one."""
    from zbot.transport import config, environment  # noqa: PLC0415 - few commands have the option

    os.environ[config.COMMAND_DOMAIN] = text
    config.domain_id()  # raises an error for an invalid domain, before the command starts
    for difference in environment.differences():
        if difference.setting.startswith("--domain"):
            print(difference.text, file=sys.stderr)


def _use_rmw(word: str) -> None:
    """Let this command and the programs that it starts speak ROS 2's Zenoh dialect.

    Args:
        word: `--rmw`, or `--rmw=` and the name of a middleware.
    """
    from zbot.transport import rmw_choice  # noqa: PLC0415 - few commands have the option

    name = word.partition("=")[2] or rmw_choice.RMW_ZENOH
    os.environ[rmw_choice.RMW_VARIABLE] = rmw_choice.known(name)


def _take_rmw(words: list[str]) -> list[str]:
    """Obey the option `--rmw` after the noun. Return the words without the option.

    After `run`, `launch` and `test`, only the first word can be this option. Later words may belong
    to the user's own program.
    """
    end = 2 if words[0] in _RUNS_PROGRAMS else len(words)
    taken = [word for word in words[1:end] if word.partition("=")[0] == "--rmw"]
    for word in taken:
        _use_rmw(word)
    return [word for index, word in enumerate(words) if index >= end or word not in taken]


def _print_and_exit(text: str) -> NoReturn:
    try:
        print(text, flush=True)
    except BrokenPipeError:
        standard_streams.silence_stdout()
    except OSError as error:
        sys.exit(standard_streams.report_fault(error))
    sys.exit(Status.OK)


def _exit_with_usage_error(text: str) -> NoReturn:
    from zbot.errors.installation import with_typed_command  # noqa: PLC0415 - only for mistakes

    text = with_typed_command(f"Error: {text}\nTry 'zbot --help' for help.")
    print(text, file=sys.stderr)
    sys.exit(Status.USAGE)


def _run_noun(words: list[str]) -> int | Callable[[], NoReturn]:
    noun = _ALIASES.get(words[0], words[0])
    if noun in _ELSEWHERE:
        _exit_with_usage_error(_ELSEWHERE[noun])
    if noun not in NOUNS and noun not in _HIDDEN:
        _exit_unknown_noun(words)
    from zbot.package.import_finder import prefer_zbot  # noqa: PLC0415 - not needed by `zbot --help`

    prefer_zbot(noun not in _USES_ROS2)
    if noun in _RUNS_PROGRAMS:
        standard_streams.restore()
        # This line raises an error before the program starts, if the current folder was deleted.
        os.getcwd()  # noqa: PTH109 - pathlib takes time to import
    if noun == "run":
        from zbot_cli.commands.run import run  # noqa: PLC0415 - does not import typer, which starts slowly

        return run(words[1:])
    if noun == "complete":
        from zbot_cli.commands.complete import complete  # noqa: PLC0415 - needed only for shells

        return complete(words[1:], NOUNS)
    if any(word[:1] == "/" and word[1:2].isdigit() for word in words):
        from zbot_cli.input import domain_names  # noqa: PLC0415 - only for names of another domain

        words = domain_names.select_domain(words) if noun in domain_names.NOUNS else words
    import typer  # noqa: PLC0415 - not needed by `zbot --help` and `zbot run`

    from zbot_cli.nouns import load  # noqa: PLC0415 - as above

    command = load(noun, words[1:])
    try:
        code = command.main(words[1:], prog_name=f"zbot {words[0]}", standalone_mode=False)
    except typer.Abort:
        return Status.INTERRUPTED
    except Exception as error:
        if not hasattr(error, "exit_code"):
            raise
        return _report_usage(error, words)
    return code if isinstance(code, int) else Status.OK


def _report_usage(error: Any, words: list[str]) -> int:
    # typer contains a copy of click, and the module name of the copy depends on typer's version.
    # So click's error classes cannot be imported, and their attributes are used instead.
    if type(error).__name__ == "NoArgsIsHelpError":
        print(error.format_message())
        return Status.OK
    error.show(sys.stderr)
    from zbot.text.typographic import advice_for_words  # noqa: PLC0415 - only for mistakes

    hint = advice_for_words(sys.argv[1:]) or _advice_for_usage(error, words)
    if hint:
        from zbot.errors.installation import with_typed_command  # noqa: PLC0415 - only for mistakes

        print(f"\nhint: {with_typed_command(hint)}", file=sys.stderr)
    return int(error.exit_code)


def _advice_for_usage(error: Any, words: list[str]) -> str:
    """Return what to type in place of an unknown verb, or an example of the verb."""
    from zbot_cli.commands.wrong_command import advice_for_verb  # noqa: PLC0415 - only for mistakes
    from zbot_cli.output.examples import EXAMPLES  # noqa: PLC0415 - as above

    message = error.format_message()
    if message.startswith("No such command"):
        return advice_for_verb(words[0], words[1:], has_suggestion="Did you mean" in message)
    example = EXAMPLES.get(" ".join(words[:2])) or EXAMPLES.get(words[0])
    if message.startswith("Got unexpected extra argument") and example:
        if words[1:2] == ["list"] and words[-1].isdigit():
            return f"write the domain of a student with a slash: /{words[-1]}"
        return f"put words that belong together in quotes; for example: {example}"
    is_missing = message.startswith(("Missing argument", "Missing option")) and example
    return f"for example: {example}" if is_missing else ""


def _exit_unknown_noun(words: list[str]) -> NoReturn:
    from zbot.errors.suggestion import did_you_mean  # noqa: PLC0415 - only for mistakes
    from zbot_cli.commands.wrong_command import advice_for_noun  # noqa: PLC0415 - as above

    text = f"No such command '{words[0]}'."
    if advice := advice_for_noun(words, NOUNS):
        print(f"Error: {text}\n\nhint: {advice}", file=sys.stderr)
        sys.exit(Status.USAGE)
    hint = did_you_mean(words[0], NOUNS, before=" ")
    _exit_with_usage_error(text + hint.replace("did", "Did", 1))  # as typer does for verbs


def _has_current_folder() -> bool:
    try:
        os.getcwd()  # noqa: PTH109 - as above
    except FileNotFoundError:
        return False
    return True


def run_command(words: list[str]) -> int | Callable[[], NoReturn]:
    """Run one command line.

    Args:
        words: All words after `zbot`.

    Returns:
        The exit code. `zbot run` gives a function instead, which runs the program and ends the
            process.
    """
    options = _Options(words)
    if not options.words:
        _print_and_exit(help_text())
    from zbot.errors import ZbotError  # noqa: PLC0415 - not needed by `zbot --help`

    try:
        if options.rmw:
            _use_rmw(options.rmw)
        if options.domain:
            _use_domain(options.domain)
        return _run_noun(_take_rmw(options.words))
    except ZbotError as error:
        if options.debug:
            raise
        from zbot_cli.output.standard_streams import report  # noqa: PLC0415 - only for errors

        _name_workspace(error)
        return report(error)
    except BrokenPipeError:
        standard_streams.silence_stdout()
        return Status.OK
    except OSError as error:
        if options.debug:
            raise
        return _report_system_error(error)
    except KeyboardInterrupt:
        return Status.INTERRUPTED


def _report_system_error(error: OSError) -> int:
    if isinstance(error, FileNotFoundError) and not _has_current_folder():
        standard_streams.print_error(
            "the current folder was deleted: go to another folder with `cd`"
        )
        return Status.ERROR
    return standard_streams.report_fault(error)


def _name_workspace(error: Any) -> None:
    """If an error is about a package of another workspace, add this workspace to the hint."""
    package = getattr(error, "package", None)
    if not isinstance(package, str):
        return
    from zbot_cli.packages.known_workspaces import folder_below, workspace_of  # noqa: PLC0415 - only for errors
    from zbot_cli.packages.setup_scripts import source_line  # noqa: PLC0415 - as above

    workspace = workspace_of(package)
    if workspace is not None:
        error.hint = (
            f"it is in the workspace {workspace}: go to that folder, or type there: {source_line()}"
        )
    elif (folder := folder_below(package)) is not None:
        error.hint = f"it is in {folder}: go to the folder {folder.parent}"


def main() -> NoReturn:
    """Run the command line of this process, and end the process."""
    standard_streams.set_up()
    try:
        keyboard_interrupt.raise_on_ctrl_c()
        outcome = run_command(sys.argv[1:])
    except (KeyboardInterrupt, ImportError) as error:
        cause = keyboard_interrupt.signal_behind(error)
        if not isinstance(cause, KeyboardInterrupt):
            raise cause  # noqa: B904 - it is the error itself, or its cause
        outcome = Status.INTERRUPTED
    # Nothing is left to clean up, so Ctrl-C ends the process from here on.
    keyboard_interrupt.end_process_on_ctrl_c()
    if callable(outcome):
        outcome()  # the program's exceptions are not caught: Python prints their tracebacks
    fault = standard_streams.flush()
    sys.exit(outcome or fault)


def launch_test() -> NoReturn:
    """Run the command line of ROS 2's `launch_test` as `zbot test`."""
    sys.argv[1:1] = ["test"]
    main()
