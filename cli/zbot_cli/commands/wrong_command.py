"""Advice for a word that is no command: a node's name, a file, or a verb without its noun."""

from __future__ import annotations

import re
import shlex
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.errors import ZbotError
from zbot.errors.suggestion import similar_names
from zbot_cli.output.examples import EXAMPLES

if TYPE_CHECKING:
    from collections.abc import Callable, Collection, Sequence

#: What users mean by words that other programs have as commands.
_COMMON_WORDS = {
    "exit": "end a node with Ctrl-C in its terminal",
    "help": "type: zbot --help",
    "kill": "end a node with Ctrl-C in its terminal, or type: zbot node kill NODE",
    "quit": "end a node with Ctrl-C in its terminal",
    "start": "type: zbot run NODE, or for a class: zbot class start",
    "stop": "end a node with Ctrl-C in its terminal, or a class with: zbot class stop",
    "version": "type: zbot --version",
}
#: Verbs for a name that stands in the place of the verb: for the name alone, and with values.
_VERBS_FOR_NAMES = {
    "action": ("info", "send_goal"),
    "bag": ("info", ""),
    "interface": ("show", ""),
    "lifecycle": ("get", "set"),
    "node": ("info", ""),
    "param": ("list", "get"),
    "pkg": ("executables", ""),
    "service": ("info", "call"),
    "topic": ("echo", "pub"),
}
#: Verbs of other programs, and the verbs of zbot.
_SYNONYMS = {
    "listen": "echo",
    "ls": "list",
    "print": "echo",
    "publish": "pub",
    "send": "pub",
    "sub": "echo",
    "subscribe": "echo",
}
_FIRST_NOUNS = ("topic", "node", "service", "param")  # beginners use these first
_FEW = 3


def advice_for_noun(words: Sequence[str], nouns: Collection[str]) -> str:
    """Return what to type in place of words whose first word is no noun, or an empty string.

    Args:
        words: The words after `zbot`.
        nouns: All nouns.
    """
    if words[0].removesuffix("s") in nouns:
        return ""  # the caller suggests the noun
    finders: tuple[Callable[[Sequence[str]], str], ...] = (
        _common_word,
        _verb_without_noun,
        _file,
        _program,
        _type,
    )
    found = next(filter(None, (find(words) for find in finders)), "")
    if found or similar_names(words[0], nouns):
        return found
    return _misspelt_verb(words) or _running(words[0])


def advice_for_verb(noun: str, words: Sequence[str], *, has_suggestion: bool) -> str:
    """Return what to type in place of words whose first word is no verb of the noun.

    Args:
        noun: The noun.
        words: The words after the noun.
        has_suggestion: Whether the user was told a similar verb of the noun.
    """
    meant = _SYNONYMS.get(words[0], words[0])
    nouns = _nouns_with(meant)
    if noun in nouns:
        return _typed(noun, meant, *words[1:])
    for place, word in enumerate(words[1:], 1):
        if noun in _nouns_with(word):  # `zbot topic temperature echo`
            return _typed(noun, word, *words[:place], *words[place + 1 :])
    if (noun, words[0]) == ("class", "status"):
        return "type: zbot class list, or for this machine: zbot status"
    if has_suggestion:
        return ""
    if nouns:
        return _typed(nouns[0], meant, *words[1:])
    verb, verb_with_values = _VERBS_FOR_NAMES.get(noun, ("", ""))
    if verb and words[1:] and words[1].startswith("/"):
        return _typed(noun, verb, *words[1:])  # an unknown verb, and a name
    verb = verb_with_values if words[1:] else verb
    return _typed(noun, verb, *words) if verb else ""


def advice_for_program(words: Sequence[str]) -> str:
    """Return what to type in place of `zbot run topic list`, or an empty string.

    Args:
        words: The words of a program that does not exist, and its arguments.
    """
    words = words[1:] if words[0] in {"ros2", "zbot"} else words
    if words[:1] and {" ".join(words[:2]), words[0]} & set(EXAMPLES):
        return _typed(*words)
    return _node(words) if words[:1] and words[0].endswith(".py") else ""


def advice_for_launch(words: Sequence[str]) -> str:
    """Return what to type in place of `zbot launch sensor`, or an empty string."""
    return advice_for_program(words) or _node(words)


def _typed(*words: str) -> str:
    return f"type: zbot {shlex.join(words)}"


def _common_word(words: Sequence[str]) -> str:
    if words[1:] and words[0] in {"python", "python3"}:
        return _typed("run", *words[1:])
    return _COMMON_WORDS.get(words[0], "")


def _verb_without_noun(words: Sequence[str]) -> str:
    verb, rest = _SYNONYMS.get(words[0], words[0]), words[1:]
    nouns = _nouns_with(verb)
    meant = [noun for noun in nouns if rest and rest[0] in {noun, f"{noun}s"}]
    if meant:  # `zbot list topics`
        return _typed(meant[0], verb, *rest[1:])
    texts = [_typed(noun, verb, *rest) for noun in nouns[:_FEW]]
    return " or ".join(texts).replace(" or type:", " or")


def _nouns_with(verb: str) -> list[str]:
    found = [key.split()[0] for key in EXAMPLES if key.split()[1:] == [verb]]
    return sorted(found, key=(*_FIRST_NOUNS, *found).index)


def _file(words: Sequence[str]) -> str:
    from zbot_cli.commands.run.missing_file import launch_file  # noqa: PLC0415 - only for mistakes

    word = words[0]
    if word.endswith((".mcap", ".db3")) or (Path(word) / "metadata.yaml").is_file():
        return _typed("bag", "info", *words)
    if error := launch_file(word):
        return error.hint
    return _typed("run", *words) if word.endswith(".py") and Path(word).is_file() else ""


def _program(words: Sequence[str]) -> str:
    from zbot_cli.packages.executables import all_packages  # noqa: PLC0415 - only for mistakes

    names = [package.name for package in all_packages() if package.executables]
    return _node(words) or (_typed("run", words[0], "NODE") if words[0] in names else "")


def _node(words: Sequence[str]) -> str:
    """Return the command that runs a node, also if it was named like a file: `turtlesim.py`."""
    from zbot_cli.commands.run.executable_search import find  # noqa: PLC0415 - only for mistakes

    words = [words[0].removesuffix(".py"), *words[1:]]
    try:
        find(words)
    except ZbotError:
        return ""
    return _typed("run", *words)


def _type(words: Sequence[str]) -> str:
    from zbot.interfaces import packages  # noqa: PLC0415 - only for mistakes
    from zbot_cli.domain.types import all_types, looks_like_type  # noqa: PLC0415 - as above

    if words[0] in packages():
        return _typed("interface", "package", words[0])
    if not looks_like_type(words[0]):
        return ""
    wanted = words[0].replace(".", "/")
    # Programs seldom use example_interfaces, which has copies of the types of std_msgs.
    for name in sorted(
        all_types(), key=lambda type_name: type_name.startswith("example_interfaces/")
    ):
        package, _, last = name.split("/")
        if wanted in {name, f"{package}/{last}", last}:
            return _typed("interface", "show", name)
    return ""


def _misspelt_verb(words: Sequence[str]) -> str:
    near = similar_names(words[0], {key.split()[-1] for key in EXAMPLES})
    return _verb_without_noun([*near, *words[1:]]) if near else ""


def _running(word: str) -> str:
    """Return the command for a word that is a name in the running domain, or an empty string."""
    from zbot.graph.snapshot import full_names  # noqa: PLC0415 - only for mistakes
    from zbot_cli.domain.client import snapshot  # noqa: PLC0415 - as above

    if re.fullmatch(r"/?[A-Za-z_]\w*(/\w+)*", word, re.ASCII) is None:
        return ""
    try:
        graph = snapshot()
    except ZbotError:
        return ""
    names = {
        "topic": [name for name, _ in graph.topics()],
        "node": full_names(graph.nodes),
        "action": [name for name, _ in graph.actions()],
        "service": [name for name, _ in graph.services()],
    }
    name = f"/{word.lstrip('/')}"
    nouns = [noun for noun, known in names.items() if name in known]
    return _typed(nouns[0], _VERBS_FOR_NAMES[nouns[0]][0], name) if nouns else ""
