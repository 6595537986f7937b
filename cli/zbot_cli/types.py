"""Types as users write them: `std_msgs/msg/String`, `std_msgs/String`, `std_msgs.msg.String`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.errors import UnknownInterfaceError, UnknownPackageError, ZbotError
from zbot.interfaces import get_spec, interface_names, packages
from zbot.names import nearest

if TYPE_CHECKING:
    from collections.abc import Iterator


class InvalidTypeError(ZbotError):
    """A word names no message type."""

    def __init__(self, word: str, hint: str | None) -> None:
        self.word, self.hint = word, hint
        super().__init__("The passed message type is invalid")


def looks_like_type(word: str) -> bool:
    """Return whether a word on the command line is meant as a type rather than as values."""
    return (
        bool(word)
        and all(part.isidentifier() for part in word.replace("/", ".").split("."))
        and ("/" in word or word.count(".") == 2 or word[0].isupper())
    )


def resolve_message_type(word: str) -> str:
    """Return the full name of a message type.

    Raises:
        InvalidTypeError: There is none of that name, or several of a short one.
    """
    parts = word.replace(".", "/").split("/")
    if len(parts) == 1:
        return _by_short_name(word)
    name = "/".join((parts[0], "msg", parts[1]) if len(parts) == 2 else parts)
    if len(parts) <= 3 and name.split("/")[1] == "msg" and _exists(name):
        return name
    raise InvalidTypeError(word, _hint(name))


def _exists(name: str) -> bool:
    try:
        get_spec(name)
    except (UnknownPackageError, UnknownInterfaceError):
        return False
    return True


def all_messages() -> Iterator[str]:
    """Yield the full name of every message type on this machine."""
    for package in packages():
        yield from (name for name in interface_names(package) if "/msg/" in name)


def _by_short_name(word: str) -> str:
    found = [name for name in all_messages() if name.endswith(f"/{word}")]
    if len(found) == 1:
        return found[0]
    if found:
        raise InvalidTypeError(word, f"there are several: {', '.join(found)}")
    raise InvalidTypeError(word, _hint(word))


def _hint(name: str) -> str | None:
    guess = nearest(name, list(all_messages()))
    if guess is None:
        last = name.rpartition("/")[2].lower()
        same = [one for one in all_messages() if one.lower().endswith(f"/{last}")]
        guess = same[0] if same else None
    return f"did you mean {guess}?" if guess else "zbot interface list shows all types"
