"""SDF document: a file, in which the included files replace each `<include>`."""

from __future__ import annotations

import copy
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element

from zbot.libraries.robot_description.file import read_description
from zbot.libraries.robot_description.xml_text import DescriptionError, read_xml
from zbot.simulation.errors import SimulationError
from zbot.simulation.sdf.notices import add_notices
from zbot.simulation.sdf.resources import find_resource
from zbot.simulation.sdf.values import text_of

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path

_MOST_FILES, _MOST_LEVELS, _MOST_ELEMENTS = 2000, 20, 500_000
#: Models that need no file: the simulator has a floor, and ignores the light.
_FLOOR, _NOTHING = frozenset({"ground_plane", "ground plane"}), frozenset({"sun"})
_FLOOR_TEXT = """<sdf version="1.7"><model name="ground_plane"><static>true</static>
<link name="link"><collision name="collision"><geometry><plane/></geometry></collision></link>
</model></sdf>"""
#: Attribute in which an element keeps the folder of its file.
FOLDER = "zbot_folder"


class Document:
    """SDF document without `<include>` tags.

    Attributes:
        root: The element `<sdf>`.
        notices: What is left out, once each.
    """

    def __init__(self, text: str, folder: Path | None = None) -> None:
        """Read a text.

        Args:
            text: The text.
            folder: The folder of relative addresses in it.

        Raises:
            SimulationError: The text is not SDF, or it includes itself or too many files.
            DescriptionError: The text is not XML.
        """
        self.notices: list[str] = []
        self._files = self._elements = 0
        self._read: dict[Path, Element] = {}
        self._found: dict[tuple[str, Path | None], Path | None] = {}  # by address and folder
        self.root = _root(text)
        self._count(self.root)
        self._expand(self.root, folder, ())

    def _count(self, root: Element) -> None:
        self._elements += sum(1 for _ in root.iter())
        if self._elements > _MOST_ELEMENTS:
            raise SimulationError(f"the world has more than {_MOST_ELEMENTS} tags")

    def _expand(self, parent: Element, folder: Path | None, chain: tuple[Path, ...]) -> None:
        """Replace all includes below an element, and note the folder of what has addresses."""
        if folder is not None:
            for tag in ("uri", "filename"):
                for found in parent.iter(tag):
                    found.attrib.setdefault(FOLDER, str(folder))
        for element in list(parent.iter()):
            if element.find("include") is None:
                continue
            children: list[Element] = []
            for child in element:
                is_include = child.tag == "include"
                children += self._included(child, folder, chain) if is_include else [child]
            element[:] = children

    def _included(
        self, include: Element, folder: Path | None, chain: tuple[Path, ...]
    ) -> Iterable[Element]:
        address = text_of(include, "uri")
        name = address.rstrip("/").rpartition("/")[2].lower()
        if name in _NOTHING:
            return []
        if name in _FLOOR:
            model = _root(_FLOOR_TEXT)[0]
        else:
            found = self._model(address, folder, chain)
            if found is None:
                return []
            model = found
        if include.get("merge", "").lower() in {"1", "true"}:
            return list(model)
        _override(model, include)
        return [model]

    def _model(self, address: str, folder: Path | None, chain: tuple[Path, ...]) -> Element | None:
        if (address, folder) not in self._found:  # a search takes long
            path = find_resource(address, folder)
            self._found[address, folder] = None if path is None else model_file(path)
        file = self._found[address, folder]
        if file is None:
            self._notice(f"the model {address[:200]}, which is not on this machine,")
            return None
        if file in chain:
            raise SimulationError(f"{file} includes itself")
        self._files += 1
        if self._files > _MOST_FILES or len(chain) >= _MOST_LEVELS:
            raise SimulationError(
                f"the world includes more than {_MOST_FILES} files, or on more than "
                f"{_MOST_LEVELS} levels"
            )
        if file not in self._read:
            self._read[file] = _root(read_description(file))
        root = copy.deepcopy(self._read[file])
        self._count(root)
        self._expand(root, file.parent, (*chain, file))
        model = next((child for child in root if child.tag in {"model", "actor"}), None)
        if model is None or model.tag == "actor":
            self._notice(f"{address[:200]}, which has no <model>,")
            return None
        model.attrib.setdefault("version", root.get("version", ""))
        return model

    def _notice(self, text: str) -> None:
        add_notices(self.notices, [text])


def _root(text: str) -> Element:
    root = read_xml(text)
    if root.tag == "gazebo":  # the name of this tag in the oldest versions
        root.tag = "sdf"
    if root.tag in {"model", "world"}:
        outer = Element("sdf")
        outer.append(root)
        root = outer
    if root.tag != "sdf":
        raise DescriptionError(f"the outermost tag is <{root.tag[:40]}>, but must be <sdf>")
    return root


def model_file(path: Path) -> Path | None:
    """Return the file of a model. A folder with a model names its files in `model.config`."""
    if path.is_file():
        return path
    try:
        files = read_xml(read_description(path / "model.config")).findall("sdf")
    except DescriptionError:
        files = []
    found = sorted(files, key=lambda tag: _version(tag.get("version", "")))
    names = [(tag.text or "").strip() for tag in reversed(found)] + ["model.sdf"]
    known = (path / name for name in names if name and ".." not in name)
    return next((file for file in known if file.is_file()), None)


def _version(text: str) -> tuple[int, ...]:
    return tuple(int(part) for part in text.split(".") if part.isdecimal())


def _override(model: Element, include: Element) -> None:
    """Change a model as its `<include>` says."""
    name = text_of(include, "name")
    if name:
        model.set("name", name)
    frame = text_of(include, "placement_frame")
    if frame:
        model.set("placement_frame", frame)
    for tag in ("pose", "static"):
        given = include.find(tag)
        if given is None or not (given.text or "").strip():
            continue
        for old in model.findall(tag):
            model.remove(old)
        model.append(given)
    for plugin in include.findall("plugin"):
        model.append(plugin)
