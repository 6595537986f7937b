"""Errors of bags. Each message is one sentence that tells the bag and the problem."""

from __future__ import annotations

from pathlib import Path

from zbot.errors import ZbotError
from zbot.errors.installation import pip_install
from zbot.errors.suggestion import did_you_mean


class BagError(ZbotError, RuntimeError):
    """Root of the errors of bags."""


class BagValueError(BagError, ValueError):
    """An option, a file with options, a topic or a field does not fit the bag."""


class NoBagExtraError(BagError, ImportError):
    """A package that reads and writes bags is not installed."""

    def __init__(self, missing: str) -> None:
        self.missing = missing
        super().__init__(f"bags need {missing}: install it with {pip_install('zbot[bag]')}")


class BagNotFoundError(BagError, LookupError):
    """There is no bag with this path."""

    def __init__(self, path: Path | str) -> None:
        self.path = str(path)
        parent = Path(path).parent
        present = [str(entry) for entry in parent.iterdir()] if parent.is_dir() else []
        self.hint = did_you_mean(str(Path(path)), present)
        super().__init__(f"Bag path '{path}' does not exist!")


class BagExistsError(BagError):
    """A new bag cannot be written, because there is a file or folder with its name.

    Args:
        path: The path of the bag.
        advice: What a program can do. A command prints the hint instead.
    """

    def __init__(self, path: Path | str, advice: str = "") -> None:
        self.path = str(path)
        self.hint = "" if advice else "choose another name with -o, or delete the folder"
        ending = f": {advice}" if advice else "."
        super().__init__(f"Output folder '{path}' already exists{ending}")


class BagReadError(BagError, ValueError):
    """A bag cannot be read."""

    def __init__(self, path: Path | str, reason: str) -> None:
        self.path, self.reason = str(path), reason
        super().__init__(f"cannot read the bag '{path}': {reason}")


class BagWriteError(BagError):
    """A bag cannot be written any more, e.g. because the disk is full."""

    def __init__(self, path: Path | str, reason: str) -> None:
        self.path, self.reason = str(path), reason
        super().__init__(f"cannot write the bag '{path}': {reason}")


def bag_topic_error(topic: str, reason: str) -> BagValueError:
    """Return the error that a message or a topic does not fit the bag."""
    return BagValueError(f"topic '{topic}' of the bag: {reason}")


class BagTypeError(BagError, LookupError):
    """This machine does not know a bag's message type, or has another definition of it."""

    def __init__(self, type_name: str, reason: str) -> None:
        self.type_name, self.reason = type_name, reason
        super().__init__(f"cannot use the message type '{type_name}' of the bag: {reason}")
