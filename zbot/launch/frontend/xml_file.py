"""Launch files in XML."""

from __future__ import annotations

from typing import TYPE_CHECKING
from xml.parsers import expat

from zbot.launch.frontend.entity import Entity
from zbot.launch.frontend.errors import InvalidFrontendLaunchFileError

if TYPE_CHECKING:
    from pathlib import Path

__all__ = ["Entity", "load"]


def load(path: Path) -> Entity:
    """Return the tree of a file.

    Raises:
        InvalidFrontendLaunchFileError: It is no XML.
    """
    parser = expat.ParserCreate()
    root = Entity("", {}, [], str(path), 0)
    open_entities = [root]

    def start(name: str, attributes: dict[str, str]) -> None:
        line = parser.CurrentLineNumber
        entity = Entity(name, dict(attributes), [], str(path), line, open_entities[-1])
        open_entities[-1].children.append(entity)
        open_entities.append(entity)

    parser.StartElementHandler = start
    parser.EndElementHandler = lambda _: open_entities.pop()
    try:
        parser.Parse(path.read_bytes(), True)
    except expat.ExpatError as error:
        reason = expat.errors.messages[error.code]
        raise InvalidFrontendLaunchFileError(str(path), error.lineno, reason) from error
    return root.children[0]
