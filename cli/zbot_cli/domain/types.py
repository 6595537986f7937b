"""Type names on the command line: `std_msgs/msg/String`, `std_msgs/String`, `String`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot import interfaces  # this package imports its modules when one of its names is used
from zbot.errors.suggestion import nearest, question
from zbot.interfaces.errors import UnknownInterfaceError, UnknownPackageError
from zbot.names import KINDS
from zbot_cli.errors import CommandError

if TYPE_CHECKING:
    from collections.abc import Container, Iterator


def check_known(word: str, kind: str, used: Container[str]) -> str:
    """Return the full name of a type: `std_msgs/String` is short for `std_msgs/msg/String`.

    Args:
        word: The name on the command line.
        kind: `msg`, `srv` or `action`.
        used: Types that nodes use. This machine may lack their definitions.

    Raises:
        CommandError: There is no such type.
    """
    name = word if word.count("/") == 2 else word.replace("/", f"/{kind}/", 1)
    if name not in used and not _exists(name):
        known = (type_name for type_name in all_types() if f"/{kind}/" in type_name)
        raise CommandError(f"Unknown type '{word}'", hint=type_hint(word, [], known))
    return name


def looks_like_type(word: str) -> bool:
    """Return whether a word on the command line looks like a type's name, not like a value."""
    return (
        bool(word)
        and all(part.isidentifier() for part in word.replace("/", ".").split("."))
        and ("/" in word or word.count(".") == 2 or word[0].isupper())
    )


def find_types(word: str) -> list[str]:
    """Return the full names of all types that match a word.

    If no type on this machine matches, the nodes are asked for a definition.
    """
    if "/" in word or "." in word:
        names = _full_names(word)
        return [name for name in names if _exists(name)] or list(filter(learn, names))
    found = [name for name in all_types() if name.endswith(f"/{word}")]
    return found or [name for name in _used_types() if name.endswith(f"/{word}") and learn(name)]


def learn(name: str) -> bool:
    """Ask nodes for the definition of a type that they use. Return whether a node had it.

    Raises:
        WrongValueError: This machine has another definition of a nested type.
    """
    from zbot.remote.types import learn_type  # noqa: PLC0415 - only for types of other machines
    from zbot_cli.domain.client import client  # noqa: PLC0415 - as above

    if len(name.split("/")) != 3 or not all(part.isidentifier() for part in name.split("/")):
        return False
    with client() as context:
        return not context.is_closed and learn_type(context, name) is not None


def _used_types() -> list[str]:
    from zbot_cli.domain.client import snapshot  # noqa: PLC0415 - only for types of other machines

    # The graph shows the services and topics of an action, such as pkg/action/Name_SendGoal.
    return sorted({end.type_name.partition("_SendGoal")[0] for end in snapshot().endpoints})


def _full_names(word: str) -> list[str]:
    parts = word.replace(".", "/").split("/")
    if len(parts) == 2:
        return [f"{parts[0]}/{kind}/{parts[1]}" for kind in KINDS]
    return ["/".join(parts)]


def _exists(name: str) -> bool:
    try:
        interfaces.get_spec(name)
    except (UnknownPackageError, UnknownInterfaceError):
        return False
    return True


def all_types() -> Iterator[str]:
    """Yield the full names of all types on this machine."""
    for package in interfaces.packages():
        yield from interfaces.interface_names(package)


def type_hint(word: str, found: list[str], known: Iterator[str]) -> str:
    """Return the hint for a word that matches no type or several types."""
    if found:
        return f"there are several: {', '.join(found)}"
    names = list(known)
    guesses = [nearest(full, names) for full in _full_names(word)] + [_short_guess(word, names)]
    guess = next(filter(None, guesses), None)
    return question([guess]) if guess else "`zbot interface list` shows all types"


def _short_guess(word: str, names: list[str]) -> str | None:
    """Return the type, of any package, whose base name is most similar to the word."""
    last = word.replace(".", "/").rpartition("/")[2]
    by_last = {name.rpartition("/")[2].lower(): name for name in reversed(names)}
    guess = nearest(last.lower(), by_last) if last == word else None
    return by_last.get(guess or last.lower())
