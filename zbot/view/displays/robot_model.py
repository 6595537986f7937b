"""Display RobotModel: the links of a robot, from its description in URDF."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from zbot.libraries.robot_description.appearance import read_appearance
from zbot.libraries.robot_description.xml_text import DescriptionError
from zbot.view import solid
from zbot.view.displays.display import Display, Setting
from zbot.view.errors import DisplayError
from zbot.view.shape import Item, Mesh

if TYPE_CHECKING:
    from zbot.libraries.robot_description.appearance import Rgba, Solid
    from zbot.view.mesh_file import MeshFiles
    from zbot.view.shape import Color

Part = Literal["visual", "collision"]
_ONE_PART: tuple[Part, ...] = ("visual", "collision")
_PARTS = (*_ONE_PART, "both")
_SURFACES = {"box": solid.box, "cylinder": solid.cylinder, "sphere": solid.sphere}


class RobotModel(Display):
    """Solids and files of all links of a robot, each at the newest pose of its link.

    The setting `hidden` has the names of links that are not shown.
    """

    name = "RobotModel"
    types = ("std_msgs/msg/String",)
    settings = (
        Setting("part", "visual", _PARTS),
        Setting("opacity", 1.0, low=0.1, high=1.0, step=0.1),
        Setting("tf prefix", ""),
        Setting("hidden", ""),
    )

    def __init__(self, topic: str, files: MeshFiles | None = None) -> None:
        super().__init__(topic, files)
        self._waiting: dict[str, list[Solid]] = {}  # links whose files are being read

    def take(self, message: Any) -> None:
        """Show a robot description."""
        self.notice, self.items = "", {}
        wanted = self.values["part"]
        parts: list[Part] = [part for part in _ONE_PART if wanted in {part, "both"}]
        self._waiting = {}
        for part in parts:
            try:
                found = read_appearance(message.data, part)
            except DescriptionError as error:
                raise DisplayError(str(error)) from error
            for link, solids in found.items():
                if link in self.words("hidden"):
                    continue
                self._waiting[link] = [*self._waiting.get(link, ()), *solids]
        if not self._waiting and not self.words("hidden"):
            names = " or ".join(f"<{part}>" for part in parts)
            raise DisplayError(f"no link of the robot description has a {names}")
        self._read()

    def tick(self, now_ns: int) -> None:  # noqa: ARG002 - the base class has it
        """Show links whose files were read meanwhile."""
        if self._waiting:
            self._read()

    def _read(self) -> None:
        mistakes = []
        for link, solids in list(self._waiting.items()):
            meshes: list[Mesh] = []
            is_read = True
            for part in solids:
                try:
                    found = self._meshes(part)
                except DisplayError as error:
                    mistakes.append(str(error))
                    continue
                is_read = is_read and found is not None
                meshes += found or ()
            if is_read:
                del self._waiting[link]
                frame = f"{self.values['tf prefix']}{link}"
                self.items[link] = Item(frame, 0, tuple(meshes))
        if mistakes:
            self.notice = mistakes[0]

    def _meshes(self, part: Solid) -> list[Mesh] | None:
        """Return the surfaces of a solid, or None as long as its file is read."""
        opacity = self.number("opacity")
        size = np.array(part.size, np.float32)
        if part.kind != "mesh":
            vertices, faces = _SURFACES[part.kind]()
            made = Mesh(vertices * size, faces, pose=part.origin)
            return [_painted(made, part.color, opacity)]
        found = self.files.get(part.file)
        if found is None:
            return None
        return [
            _painted(
                replace(mesh, vertices=mesh.vertices * size, pose=part.origin), part.color, opacity
            )
            for mesh in found
        ]


def _painted(mesh: Mesh, color: Rgba | None, opacity: float) -> Mesh:
    if color is None:
        return replace(mesh, opacity=mesh.opacity * opacity)
    red, green, blue, alpha = (min(max(part, 0.0), 1.0) for part in color)
    eight_bits: Color = (round(255 * red), round(255 * green), round(255 * blue))
    return replace(mesh, color=eight_bits, opacity=alpha * opacity)
