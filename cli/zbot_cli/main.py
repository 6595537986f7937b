"""The `zbot` command: nouns, found when they are named, and the one place where errors become text.

A noun's module is imported when it is used: `zbot --help` must answer before a student wonders.
"""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING, Any, NoReturn

from zbot_cli.input import interruption
from zbot_cli.output.exit_status import Status

if TYPE_CHECKING:
    from collections.abc import Callable

#: Every noun, with the line that `zbot --help` shows.
NOUNS = {
    "action": "Look at actions, and send goals",
    "build": "Check packages; nothing needs building",
    "class": "Open a class, and look after it",
    "completion": "Complete words in your shell with Tab",
    "daemon": "Say that no daemon is needed",
    "doctor": "Check what could be wrong",
    "graph": "Show which nodes talk to each other",
    "hub": "Link other machines to this one",
    "interface": "Look at message, service and action types",
    "join": "Join a class, or another machine",
    "launch": "Run a launch file",
    "leave": "Leave what this machine has joined",
    "lifecycle": "Lead managed nodes through their lives",
    "node": "Look at nodes",
    "param": "Look at parameters and set them",
    "pkg": "Find packages, and create them",
    "plot": "Plot numeric fields of topics",
    "run": "Run a node",
    "security": "Make certificates for machines",
    "service": "Look at services, and call them",
    "share": "Let a student see another's topics",
    "status": "Show what this machine has joined",
    "test": "Run tests, with launch files beside them",
    "topic": "Look at topics, listen and publish",
    "web": "Show the running system in a browser",
}
_ALIASES = {"wtf": "doctor"}
_HIDDEN = {"complete"}


def _version() -> str:
    import platform  # noqa: PLC0415 - only --version asks
    from importlib.metadata import version  # noqa: PLC0415 - only --version asks

    from zbot.version import __version__  # noqa: PLC0415 - only --version asks

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

  Call `zbot COMMAND --help` for more."""


class _Options:
    """What stands before the noun."""

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
            _end(_version())
        elif option in {"-h", "--help"}:
            _end(_help())
        elif option == "--config":
            if not value and not self.words:
                _refuse("Option '--config' requires a file.")
            os.environ["ZBOT_CONFIG"] = value or self.words.pop(0)
        else:
            _refuse(f"No such option: {option}")


def _end(text: str) -> NoReturn:
    print(text)
    sys.exit(Status.OK)


def _refuse(text: str) -> NoReturn:
    print(f"Error: {text}\nTry 'zbot --help' for help.", file=sys.stderr)
    sys.exit(Status.USAGE)


def _run_noun(words: list[str]) -> int | Callable[[], NoReturn]:
    noun = _ALIASES.get(words[0], words[0])
    if noun not in NOUNS and noun not in _HIDDEN:
        _refuse_noun(words[0])
    if noun == "run":
        from zbot_cli.commands.run import run  # noqa: PLC0415 - without typer: it must start at once

        return run(words[1:])
    if noun == "complete":
        from zbot_cli.commands.complete import complete  # noqa: PLC0415 - only shells ask

        return complete(words[1:], NOUNS)
    if any(word[:1] == "/" and word[1:2].isdigit() for word in words):
        from zbot_cli.input import domain_names  # noqa: PLC0415 - only for names of another domain

        words = domain_names.enter_domain(words) if noun in domain_names.NOUNS else words
    import typer  # noqa: PLC0415 - `zbot --help` and `zbot run` do without

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
    # typer brings click along, under a name that changes between its versions: go by what errors
    # can do.
    if type(error).__name__ == "NoArgsIsHelpError":
        print(error.format_message())
        return Status.OK
    error.show(sys.stderr)
    return int(error.exit_code)


def _refuse_noun(word: str) -> NoReturn:
    from zbot.names import nearest  # noqa: PLC0415 - only for mistakes

    guess = nearest(word, NOUNS)
    _refuse(f"No such command '{word}'." + (f" Did you mean '{guess}'?" if guess else ""))


def _flush() -> None:
    try:
        sys.stdout.flush()
    except BrokenPipeError:
        _silence_stdout()


def _silence_stdout() -> None:
    # Python flushes once more at exit; the reader (`| head`) has gone.
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _set_up_streams() -> None:
    for stream in (sys.stdout, sys.stderr):
        reconfigure: Any = getattr(stream, "reconfigure", None)
        if reconfigure is not None:
            reconfigure(line_buffering=True, errors="backslashreplace")


def run_command(words: list[str]) -> int | Callable[[], NoReturn]:
    """Run one command line.

    Args:
        words: Everything after `zbot`.

    Returns:
        Its exit code; of `zbot run`, the program that this process is to become.
    """
    options = _Options(words)
    if not options.words:
        _end(_help())
    from zbot.errors import ZbotError  # noqa: PLC0415 - `zbot --help` does without

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
    """Run the command line of this process, and end it."""
    _set_up_streams()
    try:
        interruption.raise_exception()
        outcome = run_command(sys.argv[1:])
    except KeyboardInterrupt:  # before or after the command itself
        outcome = Status.INTERRUPTED
    # All is done and said, or a program is about to take over.
    interruption.end_at_once()
    if callable(outcome):
        outcome()  # what it raises is the program's own
    _flush()
    sys.exit(outcome)


def launch_test() -> NoReturn:
    """Run ROS 2's command `launch_test`, which is `zbot test`."""
    sys.argv[1:1] = ["test"]
    main()
