"""Reader of the XML text of a robot. The text's size is limited. All errors have one class."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING
from xml.etree import ElementTree as ET
from xml.parsers import expat

from zbot.errors import ZbotError

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

_MAX_CHARACTERS = 20_000_000
_MAX_LEVELS = 100
_DECLARATION = re.compile(
    r"\A(?P<before>(?:[\s\ufeff]|<!--(?:(?!-->).)*-->)*)(?P<xml><\?xml\s[^>]*\?>)", re.DOTALL
)
# Python's `float` also accepts `1_0` and digits of other scripts.
_NUMBER = re.compile(r"[-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?")


class DescriptionError(ZbotError, ValueError):
    """A robot description cannot be used.

    Attributes:
        reason: What is wrong, and what to do if that is known.
    """

    def __init__(self, reason: str) -> None:
        self.reason = reason
        super().__init__(f"the robot description is not valid: {reason}")


def read_xml(text: str) -> Element:
    """Return the root element of a text.

    Raises:
        DescriptionError: The text is too long, is not XML, defines entities, declares attributes,
            or is nested deeper than 100 levels.
    """
    if len(text) > _MAX_CHARACTERS:
        raise DescriptionError(f"it has more than {_MAX_CHARACTERS} characters")
    parser, builder, level = expat.ParserCreate("utf-8"), ET.TreeBuilder(), 0

    def start(tag: str, attributes: dict[str, str]) -> None:
        nonlocal level
        level += 1
        if level > _MAX_LEVELS:
            raise DescriptionError(f"its tags are nested deeper than {_MAX_LEVELS} levels")
        builder.start(tag, attributes)

    def end(tag: str) -> None:
        nonlocal level
        level -= 1
        builder.end(tag)

    def refuse_entity(*_: object) -> None:
        raise DescriptionError("it must not define entities: remove <!ENTITY>")

    def refuse_defaults(*_: object) -> None:
        # Each element would get all default values: a short text would need much memory.
        raise DescriptionError("it must not declare attributes: remove <!ATTLIST>")

    parser.StartElementHandler, parser.EndElementHandler = start, end
    parser.CharacterDataHandler = builder.data
    parser.EntityDeclHandler, parser.AttlistDeclHandler = refuse_entity, refuse_defaults
    try:
        parser.Parse(_without_declaration(text).encode("utf-8", "replace"), True)
        return builder.close()
    except expat.ExpatError as error:
        raise DescriptionError(f"line {error.lineno}: {expat.ErrorString(error.code)}") from None


def _without_declaration(text: str) -> str:
    """Return a text in which blanks replace `<?xml ...?>`.

    The text is already decoded, so the encoding in the declaration must be ignored. ROS 2 accepts
    blank lines and comments before the declaration, which XML does not allow.
    """
    return _DECLARATION.sub(lambda match: match["before"] + re.sub(r"\S", " ", match["xml"]), text)


def numbers(text: str, count: int, where: str) -> tuple[float, ...]:
    """Return the numbers of an attribute such as `xyz="0 0 1"`.

    Raises:
        DescriptionError: The number of words is not `count`, or a word is not a finite number.
    """
    words = text.split()
    try:
        values = tuple(float(word) for word in words if _NUMBER.fullmatch(word))
    except ValueError:
        values = ()
    if not len(words) == len(values) == count or not all(
        abs(value) < float("inf") for value in values
    ):
        what = "a number" if count == 1 else f"{count} numbers"
        raise DescriptionError(f"{where} must be {what}, not '{text[:40]}'")
    return values
