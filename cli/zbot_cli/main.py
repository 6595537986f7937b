"""Entry point of the `zbot` command. It runs the noun, such as `topic`, and prints errors.

It imports only the module of this noun, so that `zbot --help` is fast.
"""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING, Any, NoReturn

from zbot_cli.input import keyboard_interrupt
from zbot_cli.output.exit_status import Status

if TYPE_CHECKING:
    from collections.abc import Callable

#: All nouns. Each has the line that `zbot --help` shows for it.
NOUNS = {
    "action": "Look at actions and send goals",
    "build": "Check packages; nothing needs building",
    "class": "Start and manage a class",
    "completion": "Complete words in your shell with Tab",
    "daemon": "Say that no daemon is needed",
    "doctor": "Check this machine and the domain for problems",
    "graph": "Show which nodes talk to each other",
    "hub": "Link other machines to this one",
    "interface": "Look at message, service and action types",
    "join": "Join a class or another machine",
    "launch": "Run a launch file",
    "leave": "Leave the class or the other machine",
    "lifecycle": "Look at managed nodes, change their states",
    "node": "Look at nodes",
    "param": "Look at parameters and set them",
    "pkg": "Find and create packages",
    "plot": "Plot numeric fields of topics",
    "run": "Run a node",
    "security": "Make certificates for machines",
    "service": "Look at services and call them",
    "share": "Let one student read another's topics",
    "status": "Show the class or the other machine",
    "test": "Run tests and launch tests",
    "topic": "Look at topics, print and publish messages",
    "web": "Show the running system in a browser",
}
_ALIASES = {"wtf": "doctor"}
_HIDDEN = {"complete"}


def _version() -> str:
    import platform  # noqa: PLC0415 - needed only for --version
    from importlib.metadata import version  # noqa: PLC0415 - needed only for --version

    from zbot.version import __version__  # noqa: PLC0415 - needed only for --version

    return (
        f"zbot {__version__} (eclipse-zenoh {version('eclipse-zenoh')}, "
        f"Python {platform.python_version()}, {platform.system()} {platform.machine()})"
    )


def _help() -> str:
    width = max(map(len, NOUNS))
    nouns = "\n".join(f"  {noun:<{width}}  {text}" for noun, text in NOUNS.items())
    return f"""\
Usage: zbot [OPTIONS] COMMAND [ARGS]...

  Robots in Python: nodes, topics, services and actions in the words of ROS 2.

Options:
  --config FILE  Zenoh configuration for this command [env: ZBOT_CONFIG]
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
            _print_and_exit(_help())
        elif option == "--config":
            if not value and not self.words:
                _exit_with_usage_error("Option '--config' requires a file.")
            os.environ["ZBOT_CONFIG"] = value or self.words.pop(0)
        else:
            _exit_with_usage_error(f"No such option: {option}")


def _print_and_exit(text: str) -> NoReturn:
    print(text)
    sys.exit(Status.OK)


def _exit_with_usage_error(text: str) -> NoReturn:
    print(f"Error: {text}\nTry 'zbot --help' for help.", file=sys.stderr)
    sys.exit(Status.USAGE)


def _run_noun(words: list[str]) -> int | Callable[[], NoReturn]:
    noun = _ALIASES.get(words[0], words[0])
    if noun not in NOUNS and noun not in _HIDDEN:
        _exit_unknown_noun(words[0])
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
        return _report_usage(error)
    return code if isinstance(code, int) else Status.OK


def _report_usage(error: Any) -> int:
    # typer contains a copy of click, and the module name of the copy depends on typer's version.
    # So click's error classes cannot be imported, and their attributes are used instead.
    if type(error).__name__ == "NoArgsIsHelpError":
        print(error.format_message())
        return Status.OK
    error.show(sys.stderr)
    return int(error.exit_code)


def _exit_unknown_noun(word: str) -> NoReturn:
    from zbot.names import nearest  # noqa: PLC0415 - only for mistakes

    guess = nearest(word, NOUNS)
    question = f" Did you mean '{guess}'?" if guess else ""
    _exit_with_usage_error(f"No such command '{word}'.{question}")


def _flush() -> None:
    try:
        sys.stdout.flush()
    except BrokenPipeError:
        _silence_stdout()


def _silence_stdout() -> None:
    # The reader (`| head`) has closed the pipe, and Python flushes once more at exit.
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _set_up_streams() -> None:
    for stream in (sys.stdout, sys.stderr):
        reconfigure: Any = getattr(stream, "reconfigure", None)
        if reconfigure is not None:
            reconfigure(line_buffering=True, errors="backslashreplace")


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
        _print_and_exit(_help())
    from zbot.errors import ZbotError  # noqa: PLC0415 - not needed by `zbot --help`

    try:
        return _run_noun(options.words)
    except ZbotError as error:
        if options.debug:
            raise
        from zbot_cli.output.report import report  # noqa: PLC0415 - only for errors

        return report(error)
    except BrokenPipeError:
        _silence_stdout()
        return Status.OK
    except KeyboardInterrupt:
        return Status.INTERRUPTED


def main() -> NoReturn:
    """Run the command line of this process, and end the process."""
    _set_up_streams()
    try:
        keyboard_interrupt.raise_on_ctrl_c()
        outcome = run_command(sys.argv[1:])
    except KeyboardInterrupt:  # during the command, `run_command` catches it
        outcome = Status.INTERRUPTED
    # Nothing is left to clean up, so Ctrl-C ends the process from here on.
    keyboard_interrupt.end_process_on_ctrl_c()
    if callable(outcome):
        outcome()  # the program's exceptions are not caught: Python prints their tracebacks
    _flush()
    sys.exit(outcome)


def launch_test() -> NoReturn:
    """Run the command line of ROS 2's `launch_test` as `zbot test`."""
    sys.argv[1:1] = ["test"]
    main()
