"""Reader of package.xml files."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING
from xml.etree import ElementTree as ET
from xml.parsers import expat

from zbot.errors import ZbotError

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
    for tag in _REQUIRED:
        if not _text(root, tag):
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


def read_tree(path: Path) -> Element:
    """Return the root element of a package.xml.

    Raises:
        ManifestError: The file cannot be read, is not valid XML or defines entities.
    """
    try:
        source = path.read_bytes()
    except OSError as exc:
        raise ManifestError(path, 0, exc.strerror or str(exc)) from exc
    if b"<!ENTITY" in source:
        raise ManifestError(path, 0, "a package.xml must not define entities: remove <!ENTITY>")
    try:
        return ET.fromstring(source)  # noqa: S314 - safe without entities
    except ET.ParseError as exc:
        reason = expat.ErrorString(exc.code)
        raise ManifestError(path, exc.position[0], f"not valid XML: {reason}") from None


def _text(root: Element, tag: str) -> str:
    return (root.findtext(tag) or "").strip()


def _texts(root: Element, tag: str) -> list[str]:
    return [text for one in root.findall(tag) if (text := (one.text or "").strip())]


def _line(path: Path, tag: str) -> int:
    """Return the line of a tag, or the last line if the tag is missing."""
    lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
    found = (number for number, line in enumerate(lines, 1) if f"<{tag}" in line)
    return next(found, len(lines))
