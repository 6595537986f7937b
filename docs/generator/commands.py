"""Page of all commands and options, written from the commands themselves."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot_cli.commands.run import USAGE
from zbot_cli.main import NOUNS, help_text
from zbot_cli.nouns import load, verbs
from zbot_cli.output.examples import EXAMPLES

if TYPE_CHECKING:
    from collections.abc import Iterator

_HEAD = """\
# Commands

Every command of zbot, with its arguments and options. `zbot COMMAND --help` prints the same.
`python -m docs.generator` writes this page from the code.

These options come before the command, e.g. `zbot --domain 7 node list`:
"""


def page() -> str:
    """Return the text of the page."""
    return "\n".join(_lines()) + "\n"


def _lines() -> Iterator[str]:
    yield _HEAD
    options = help_text().partition("Options:\n")[2].partition("\n\n")[0]
    yield f"```text\n{options}\n```\n"
    for noun, text in NOUNS.items():
        yield f"## zbot {noun}\n\n{text}.\n"
        if noun == "run":
            yield from _run_usage()
            continue
        command = load(noun)
        found = verbs(command)
        for name, verb in found.items():
            if not verb.hidden:
                yield f"### zbot {noun} {name}\n"
                yield from _verb(f"{noun} {name}", verb)
        if not found:
            yield from _verb(noun, command)


def _run_usage() -> Iterator[str]:
    yield f"```text\n{USAGE}\n```\n"


def _verb(words: str, command: Any) -> Iterator[str]:
    parameters = [
        parameter for parameter in command.params if not getattr(parameter, "hidden", False)
    ]
    arguments = [parameter for parameter in parameters if parameter.param_type_name == "argument"]
    options = [parameter for parameter in parameters if parameter.param_type_name == "option"]
    usage = " ".join(["zbot", words, *(["[OPTIONS]"] if options else []), *map(_usage, arguments)])
    yield f"```text\n{usage}\n```\n"
    yield f"{_text(command.help)}\n"
    rows = [*map(_argument, arguments), *map(_option, options)]
    if rows:
        yield "| | |\n|---|---|"
        yield from rows
        yield ""
    if words in EXAMPLES:
        examples = ", ".join(f"`{line.strip()}`" for line in EXAMPLES[words].split("\n"))
        yield f"Example: {examples}\n"


def _usage(argument: Any) -> str:
    text = argument.metavar or argument.name.upper()
    text += "..." if argument.nargs == -1 and "..." not in text else ""
    return text if argument.required or text.startswith("[") else f"[{text}]"


def _argument(argument: Any) -> str:
    return f"| `{_usage(argument)}` | {_cell(argument.help)} |"


def _option(option: Any) -> str:
    names = ", ".join(f"`{name}`" for name in (*option.opts, *option.secondary_opts))
    value = "" if option.is_flag or option.count else f" `{_value(option)}`"
    default = getattr(option.default, "value", option.default)
    is_shown = default is not True and default not in (None, "", (), 0) and not callable(default)
    more = f" (default: `{default}`)" if is_shown and not isinstance(default, list) else ""
    return f"| {names}{value} | {_cell(option.help)}{more} |"


def _value(option: Any) -> str:
    choices = getattr(option.type, "choices", None)
    if option.metavar or not choices:
        return str(option.metavar or option.type.name.upper().removesuffix(" RANGE"))
    return " or ".join(map(str, choices))


def _text(text: str | None) -> str:
    """Return a docstring as paragraphs of Markdown."""
    return (text or "").replace("\b\n", "").strip()


def _cell(text: str | None) -> str:
    """Return a text as one cell of a table."""
    return " ".join((text or "").split()).replace("|", "\\|").replace("<", "&lt;")
