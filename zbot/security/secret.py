"""Secrets that do not print themselves, and files that only their owner reads."""

from __future__ import annotations

import hmac
import os
import secrets
import tempfile
from pathlib import Path
from typing import Final

_RANDOM_BYTES = 16  #: as hard to guess as an AES-128 key
FILE_MODE: Final = 0o600
FOLDER_MODE: Final = 0o700


class Secret:
    """A PIN or password: `repr`, `str` and f-strings show only that there is one.

    Whoever needs the text calls `reveal`, which is easy to search for. Pickling is refused, as a
    pickle would carry the text.
    """

    __slots__ = ("_text",)

    def __init__(self, text: str) -> None:
        self._text = text

    @classmethod
    def random(cls) -> Secret:
        """Return a new secret of 32 hexadecimal digits that nobody can guess."""
        return cls(secrets.token_hex(_RANDOM_BYTES))

    def reveal(self) -> str:
        """Return the text itself; never put it on a command line or into a log."""
        return self._text

    def __repr__(self) -> str:
        return "Secret(...)"

    def __str__(self) -> str:
        return "..."

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Secret):
            return NotImplemented
        # In a time that does not tell how much of a guess was right.
        return hmac.compare_digest(self._text.encode(), other._text.encode())

    def __hash__(self) -> int:
        return hash(self._text)

    def __reduce__(self) -> str:
        raise TypeError("a Secret is not pickled: pass it through a file that only its owner reads")


def make_private_folder(folder: Path) -> None:
    """Make a folder, and those above it, that only its owner can look into.

    An existing one gets the same mode. On Windows a folder inside the user's own has that already,
    and the mode changes nothing.

    Raises:
        OSError: It cannot be made.
    """
    folder.mkdir(mode=FOLDER_MODE, parents=True, exist_ok=True)
    folder.chmod(FOLDER_MODE)


def write_private(path: Path, content: bytes) -> None:
    """Write a file that only its owner reads, whole or not at all; an existing one is replaced.

    Raises:
        OSError: It cannot be written.
    """
    # mkstemp makes the file with mode 0600, so nobody can open it while it is being written.
    descriptor, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    try:
        with os.fdopen(descriptor, "wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        Path(name).replace(path)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise
