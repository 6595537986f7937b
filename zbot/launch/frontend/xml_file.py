"""Reader of launch files in XML."""

from __future__ import annotations

from typing import TYPE_CHECKING
from xml.parsers import expat

from zbot.launch.errors import InvalidFrontendLaunchFileError
from zbot.launch.frontend.entity import Entity
from zbot.text.typographic import advice

if TYPE_CHECKING:
    from pathlib import Path

_MAX_LEVELS = 100

__all__ = ["Entity", "load", "parse"]


def load(path: Path) -> Entity:
    """Return the tree of a file. See `parse`."""
    return parse(path.read_bytes(), str(path))


def parse(content: bytes | str, path: str) -> Entity:
    """Return the tree of XML content.

    Raises:
        InvalidFrontendLaunchFileError: The content is not XML.
    """
    parser = expat.ParserCreate()
    root = Entity("", {}, [], path, 0)
    open_entities = [root]

    def start(name: str, attributes: dict[str, str]) -> None:
        line = parser.CurrentLineNumber
        if len(open_entities) > _MAX_LEVELS:
            reason = f"its tags are nested deeper than {_MAX_LEVELS} levels"
            raise InvalidFrontendLaunchFileError(path, line, reason)
        entity = Entity(name, dict(attributes), [], path, line, parent=open_entities[-1])
        open_entities[-1].add(entity)
        open_entities.append(entity)

    parser.StartElementHandler = start
    parser.EndElementHandler = lambda _: open_entities.pop()

    def refuse(*_: object) -> None:
        reason = "a launch file must not define entities: remove <!ENTITY>"
        raise InvalidFrontendLaunchFileError(path, parser.CurrentLineNumber, reason)

    def refuse_defaults(*_: object) -> None:
        # Each tag would get all default values of its attributes, and so fill the memory.
        reason = "a launch file must not define attributes: remove <!ATTLIST>"
        raise InvalidFrontendLaunchFileError(path, parser.CurrentLineNumber, reason)

    parser.EntityDeclHandler, parser.AttlistDeclHandler = refuse, refuse_defaults
    try:
        parser.Parse(content, True)
    except expat.ExpatError as error:
        text = content if isinstance(content, str) else content.decode(errors="replace")
        hint = advice("".join(text.splitlines()[error.lineno - 1 :][:1]))
        reason = f"{expat.errors.messages[error.code]}{': ' if hint else ''}{hint}"
        raise InvalidFrontendLaunchFileError(path, error.lineno, reason) from error
    except (LookupError, ValueError) as error:
        if isinstance(error, InvalidFrontendLaunchFileError):
            raise
        reason = f"its encoding cannot be read: {error}"
        raise InvalidFrontendLaunchFileError(path, 1, reason) from error
    return root.children[0]
