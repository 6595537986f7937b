"""Secrets that are never printed, and files that only their owner can read."""

from __future__ import annotations

import hmac
import os
import secrets
import tempfile
from pathlib import Path
from typing import Final

from zbot.package.user_folders import make_private

_RANDOM_BYTES = 16  #: as hard to guess as an AES-128 key
FOLDER_MODE: Final = 0o700


class Secret:
    """PIN or password that `repr`, `str` and f-strings do not show.

    Only `reveal` returns the text. A `Secret` cannot be pickled, because a pickle would contain the
    text.
    """

    __slots__ = ("_text",)

    def __init__(self, text: str) -> None:
        self._text = text

    @classmethod
    def random(cls) -> Secret:
        """Return a new random secret of 32 hexadecimal digits."""
        return cls(secrets.token_hex(_RANDOM_BYTES))

    def reveal(self) -> str:
        """Return the text itself. Never put it on a command line or into a log."""
        return self._text

    def __repr__(self) -> str:
        return "Secret(...)"

    def __str__(self) -> str:
        return "..."

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Secret):
            return NotImplemented
        # The time of this comparison does not depend on how many characters are equal.
        return hmac.compare_digest(self._text.encode(), other._text.encode())

    def __hash__(self) -> int:
        return hash(self._text)

    def __reduce__(self) -> str:
        raise TypeError("cannot pickle a Secret: pass it through a file that only its owner reads")


def make_private_folder(folder: Path) -> None:
    """Make a folder that only its owner can list, and make its missing parents.

    If the folder exists, its mode changes. On Windows, the mode has no effect, but folders
    inside the user's folder are private already.

    Raises:
        OSError: The folder cannot be made.
    """
    make_private(folder)
    folder.chmod(FOLDER_MODE)


def write_private(path: Path, content: bytes) -> None:
    """Write a file that only its owner can read. An existing file is replaced in one step.

    Raises:
        OSError: The file cannot be written.
    """
    # mkstemp makes the file with mode 0600, so no other user can open it while it is written.
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
