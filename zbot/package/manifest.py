"""Reader of package.xml files."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING
from xml.etree import ElementTree as ET
from xml.parsers import expat

from zbot.errors import ZbotError
from zbot.package.condition import ConditionError, holds

if TYPE_CHECKING:
    from pathlib import Path
    from xml.etree.ElementTree import Element

#: Tags of the dependencies that a program may import at run time. `_TAGS` has all tags.
RUNTIME_TAGS = ("depend", "exec_depend", "run_depend", "build_export_depend")
_TAGS = (
    *RUNTIME_TAGS,
    "build_depend",
    "buildtool_depend",
    "test_depend",
    "buildtool_export_depend",
)
_MAX_BYTES = 256 * 1024
_MAX_LEVELS = 100
_LONGEST_NAMESPACE = 1000  #: in characters. Each tag's name would contain it
_REQUIRED = ("name", "version", "description", "maintainer", "license")
_NAME = re.compile(r"[a-zA-Z0-9][a-zA-Z0-9_-]*\Z")
_VERSION = re.compile(r"\d+\.\d+\.\d+\Z")


class ManifestError(ZbotError, ValueError):
    """A package.xml cannot be read, or a required element is missing or invalid.

    Attributes:
        path: The file.
        line: The line, counted from 1. It is 0 if the error is about the whole file.
        reason: What is wrong.
    """

    def __init__(self, path: Path, line: int, reason: str) -> None:
        self.path, self.line, self.reason = path, line, reason
        super().__init__(f"{path}:{line}: {reason}" if line else f"{path}: {reason}")


@dataclass(frozen=True)
class Manifest:
    """Contents of a package.xml."""

    name: str
    build_type: str
    depends: dict[str, tuple[str, ...]] = field(default_factory=dict)  #: tag -> packages
    groups: tuple[str, ...] = ()  #: the groups of which the package is a member

    def named(self, *tags: str) -> set[str]:
        """Return the packages under these tags. Without tags, return the packages under any tag."""
        return {name for tag in tags or _TAGS for name in self.depends.get(tag, ())}


def read_manifest(path: Path) -> Manifest:
    """Return the contents of a package.xml.

    Raises:
        ManifestError: The file is not valid XML, or ROS 2 would not accept it.
    """
    root = read_tree(path)
    if root.tag != "package":
        raise ManifestError(path, 1, f"the outermost tag is <{root.tag}>, but must be <package>")
    _remove_what_does_not_apply(path, root)
    for tag in _REQUIRED:
        if not _whole_text(root, tag):
            raise ManifestError(path, _line(path, tag), f"<{tag}> is missing or empty")
    name, version = _text(root, "name"), _text(root, "version")
    if not _NAME.match(name):
        raise ManifestError(path, _line(path, "name"), f"'{name}' is not a valid package name")
    if not _VERSION.match(version):
        reason = f"the version is '{version}', but must be three numbers, such as 0.1.0"
        raise ManifestError(path, _line(path, "version"), reason)
    depends = {tag: tuple(_texts(root, tag)) for tag in _TAGS}
    build_type = _text(root, "export/build_type") or "catkin"
    return Manifest(name, build_type, depends, tuple(_texts(root, "member_of_group")))


def build_type_in(path: Path) -> str:
    """Return the build type in a package.xml, which may lack other parts, or an empty string.

    Raises:
        ManifestError: The file is not valid XML.
    """
    root = read_tree(path)
    _remove_what_does_not_apply(path, root)
    return _text(root, "export/build_type")


def read_tree(path: Path) -> Element:
    """Return the root element of a package.xml.

    Raises:
        ManifestError: The file cannot be read, is not valid XML or defines entities.
    """
    try:
        with path.open("rb") as file:
            source = file.read(_MAX_BYTES + 1)
    except OSError as exc:
        raise ManifestError(path, 0, exc.strerror or str(exc)) from exc
    if len(source) > _MAX_BYTES:
        raise ManifestError(path, 0, f"a package.xml must not have more than {_MAX_BYTES} bytes")
    try:
        _check(path, source)
        return ET.fromstring(source)  # noqa: S314 - safe without entities
    except (ET.ParseError, expat.ExpatError) as exc:
        reason = expat.ErrorString(exc.code)
        line = exc.position[0] if isinstance(exc, ET.ParseError) else exc.lineno
        raise ManifestError(path, line, f"not valid XML: {reason}") from None
    except (LookupError, ValueError) as exc:
        if isinstance(exc, ManifestError):
            raise
        raise ManifestError(path, 1, f"its encoding cannot be read: {exc}") from None


def _check(path: Path, source: bytes) -> None:
    """Check what could fill the memory, before a tree is made. It works for all encodings."""
    parser, level = expat.ParserCreate(), 0

    def refuse(*_: object) -> None:
        raise ManifestError(path, 0, "a package.xml must not define entities: remove <!ENTITY>")

    def refuse_defaults(*_: object) -> None:
        # Each tag would get all default values of its attributes.
        raise ManifestError(path, 0, "a package.xml must not define attributes: remove <!ATTLIST>")

    def begin(_: str, attributes: dict[str, str]) -> None:
        nonlocal level
        level += 1
        if level > _MAX_LEVELS:
            reason = f"its tags are nested deeper than {_MAX_LEVELS} levels"
            raise ManifestError(path, parser.CurrentLineNumber, reason)
        for name, value in attributes.items():
            if name.startswith("xmlns") and len(value) > _LONGEST_NAMESPACE:
                reason = f"a namespace has more than {_LONGEST_NAMESPACE} characters"
                raise ManifestError(path, parser.CurrentLineNumber, reason)

    def end(_: str) -> None:
        nonlocal level
        level -= 1

    parser.EntityDeclHandler, parser.AttlistDeclHandler = refuse, refuse_defaults
    parser.StartElementHandler, parser.EndElementHandler = begin, end
    parser.Parse(source, True)


def _remove_what_does_not_apply(path: Path, root: Element) -> None:
    """Remove the elements whose attribute `condition` is false."""
    for parent in (root, *root.findall("export")):
        # `Element.remove` would search each element from the start.
        parent[:] = [element for element in parent if _applies(path, element)]


def _applies(path: Path, element: Element) -> bool:
    try:
        return holds(element.get("condition", "1==1"))
    except ConditionError as error:
        raise ManifestError(path, _line(path, str(element.tag)), str(error)) from None


def _whole_text(root: Element, tag: str) -> str:
    """Return the text of an element and of the markup in it, e.g. `<description><p>A</p>`."""
    found = root.find(tag)
    return "".join(found.itertext()).strip() if found is not None else ""


def _text(root: Element, tag: str) -> str:
    return (root.findtext(tag) or "").strip()


def _texts(root: Element, tag: str) -> list[str]:
    return [text for element in root.findall(tag) if (text := (element.text or "").strip())]


def _line(path: Path, tag: str) -> int:
    """Return the line of a tag, or the last line if the tag is missing."""
    lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
    found = (number for number, line in enumerate(lines, 1) if f"<{tag}" in line)
    return next(found, len(lines))
