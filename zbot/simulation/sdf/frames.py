"""Frames of an SDF model: the poses of its links, joints and nested models in the model."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.libraries.robot_description.xml_text import DescriptionError
from zbot.simulation.sdf.values import pose_of, relative_to
from zbot.tf2.rigid import Rigid

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

_WITH_FRAMES = ("link", "joint", "frame", "model")
_MOST_STEPS = 200
_LONGEST_NAME = 500  #: each name in a model is repeated in the names of all that is in it


class Frames:
    """Frames of one model, also of the models in it. Their names have the form `arm::hand`."""

    def __init__(self, model: Element) -> None:
        #: For each frame: the frame in which its pose is, and the pose.
        self._known: dict[str, tuple[str, Rigid]] = {"": ("", Rigid())}
        self._found: dict[str, Rigid] = {"": Rigid()}
        self._add(model, "")

    def _add(self, model: Element, scope: str) -> None:
        for element in model:
            name = element.get("name", "")
            if element.tag not in _WITH_FRAMES or not name:
                continue
            if len(name) > _LONGEST_NAME:
                raise DescriptionError(f"a name has more than {_LONGEST_NAME} characters")
            parent = relative_to(element) or _usual_parent(element)
            is_outer = parent in {"", "__model__"}
            # A joint to the world has no child link to stand on.
            base = scope.removesuffix("::") if is_outer or parent == "world" else scope + parent
            self._known[scope + name] = (base, pose_of(element))
            if element.tag == "model":
                self._add(element, f"{scope}{name}::")

    def pose(self, name: str) -> Rigid:
        """Return the pose of a frame in the model.

        Raises:
            DescriptionError: There is no such frame, or frames are relative to each other.
        """
        chain: list[str] = []
        while name not in self._found:
            if name not in self._known:
                raise DescriptionError(f"there is no frame '{name[:60]}'")
            if name in chain or len(chain) > _MOST_STEPS:
                raise DescriptionError(f"the pose of '{name[:60]}' is relative to itself")
            chain.append(name)
            name = self._known[name][0]
        pose = self._found[name]
        for link in reversed(chain):
            pose = self._found[link] = pose @ self._known[link][1]
        return pose

    def knows(self, name: str) -> bool:
        """Return whether there is a frame of this name."""
        return name in self._known


def _usual_parent(element: Element) -> str:
    if element.tag == "joint":
        return (element.findtext("child") or "").strip()
    return element.get("attached_to", "")
