"""The model in the 3D view is where forward kinematics puts it: xacro, surfaces, joint sliders."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

import zbot
from tests.conftest import wait_until
from zbot.tf2.diagnosis import TransformMonitor
from zbot.view.displays.robot_model import RobotModel
from zbot.view.frames import Frames
from zbot.view.shape import Mesh
from zbot_nodes.description.joint_state_publisher_gui import JointStatePublisherGui
from zbot_nodes.description.robot_state_publisher import RobotStatePublisher

from std_msgs.msg import String

if TYPE_CHECKING:
    from pathlib import Path

    from numpy.typing import NDArray

    from tests.nodes.conftest import Bench

    Matrix = NDArray[np.float64]

#: The corners of the only triangle of the surface.
CORNERS = np.array([(0.0, 0.0, 0.0), (0.1, 0.0, 0.0), (0.0, 0.2, 0.3)])
STL = "solid s\nfacet normal 0 0 1\nouter loop\n{}\nendloop\nendfacet\nendsolid s\n".format(
    "\n".join(f"vertex {x} {y} {z}" for x, y, z in CORNERS)
)
#: A joint: its type, its parent, its origin and its axis.
JOINTS: dict[str, tuple[str, str, tuple[float, ...], tuple[float, ...], tuple[float, ...]]] = {
    "pan": ("continuous", "base", (0.1, 0.2, 0.3), (0.1, -0.4, 1.2), (0, 0, 1)),
    "lift": ("revolute", "pan", (0, 0.3, 0.1), (1.5, 0, -0.7), (0.6, 0, 0.8)),
    "slide": ("prismatic", "lift", (0.2, 0, 0), (0, 0.9, 0.3), (0, 1, 0)),
    "mount": ("fixed", "slide", (0, 0, -0.4), (3.0, 0.2, -2.0), (1, 0, 0)),
    "finger": ("revolute", "mount", (0.05, 0, 0.05), (0, 0, 0.5), (1, 0, 0)),
}
VISUAL = ((0.01, 0.02, 0.03), (0.3, 0.2, 0.1))
SIZE = (1.0, 2.0, 0.5)
POSITIONS = {"pan": 2.5, "lift": -0.8, "slide": 0.35, "finger": 1.1}
XACRO = """<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:arg name="folder" default=""/>
<xacro:macro name="part" params="name">
  <link name="${{name}}"><visual><origin xyz="{}" rpy="{}"/>
    <geometry><mesh filename="file://$(arg folder)/part.stl" scale="{}"/></geometry></visual></link>
</xacro:macro>
<xacro:macro name="joined" params="name parent type xyz rpy axis">
  <xacro:part name="${{name}}"/>
  <joint name="to_${{name}}" type="${{type}}"><parent link="${{parent}}"/><child link="${{name}}"/>
    <origin xyz="${{xyz}}" rpy="${{rpy}}"/><axis xyz="${{axis}}"/>
    <limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
</xacro:macro>
<xacro:part name="base"/>
{}
</robot>"""


def words(numbers: tuple[float, ...]) -> str:
    return " ".join(map(str, numbers))


def description(folder: Path) -> str:
    """Return the description of the arm as xacro writes it."""
    xacro = pytest.importorskip("xacro", reason="an extra: pip install 'zbot[robot]'")
    joined = [
        f'<xacro:joined name="{name}" parent="{parent}" type="{kind}" xyz="{words(xyz)}" '
        f'rpy="{words(rpy)}" axis="{words(axis)}"/>'
        for name, (kind, parent, xyz, rpy, axis) in JOINTS.items()
    ]
    place, turn = VISUAL
    text = XACRO.format(words(place), words(turn), words(SIZE), "\n".join(joined))
    (folder / "arm.urdf.xacro").write_text(text)
    (folder / "part.stl").write_text(STL)
    mapping = {"folder": str(folder)}
    return str(xacro.process_file(str(folder / "arm.urdf.xacro"), mappings=mapping).toxml())


# -- forward kinematics with matrices, without zbot's own transforms -----------------------------


def around(axis: tuple[float, ...], angle: float) -> Matrix:
    """Return a rotation by the formula of Rodrigues."""
    x, y, z = axis
    cross = np.array([(0, -z, y), (z, 0, -x), (-y, x, 0)])
    turned: Matrix = np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
    return turned


def at(xyz: Any, rotation: Matrix) -> Matrix:
    made = np.eye(4)
    made[:3, :3], made[:3, 3] = rotation, xyz
    return made


def origin(xyz: tuple[float, ...], rpy: tuple[float, ...]) -> Matrix:
    roll, pitch, yaw = rpy
    turn = around((0, 0, 1), yaw) @ around((0, 1, 0), pitch) @ around((1, 0, 0), roll)
    return at(xyz, turn)


def forward(link: str) -> Matrix:
    """Return the pose of a link in the frame `base`."""
    if link == "base":
        return np.eye(4)
    kind, parent, xyz, rpy, axis = JOINTS[link]
    position = POSITIONS.get(link, 0.0)
    moved = at((0, 0, 0), around(axis, position))
    if kind in {"prismatic", "fixed"}:
        moved = at(np.array(axis) * position, np.eye(3))
    return forward(parent) @ origin(xyz, rpy) @ moved


def corners(link: str) -> Matrix:
    """Return the corners of a link's surface in the frame `base`."""
    whole = forward(link) @ origin(*VISUAL)
    moved: Matrix = (CORNERS * SIZE) @ whole[:3, :3].T + whole[:3, 3]
    return moved


# -- the view ------------------------------------------------------------------------------------


def shown(frames: Frames, model: RobotModel, link: str) -> Matrix:
    """Return the corners of a link's surface in the fixed frame, as the view draws them."""
    item = model.items[link]
    pose, _ = frames.pose(item.frame, item.stamp_ns)
    assert pose is not None
    (mesh,) = item.shapes
    assert isinstance(mesh, Mesh)
    whole = pose @ item.pose @ mesh.pose
    return np.array([whole.apply((x, y, z)) for x, y, z in mesh.vertices.tolist()])


def test_sliders_move_the_model_as_forward_kinematics_does(bench: Bench, tmp_path: Path) -> None:
    pytest.importorskip("trimesh", reason='surfaces need the extra: pip install "zbot[view]"')
    text = description(tmp_path)
    bench.run(RobotStatePublisher, {"robot_description": text})
    sliders = bench.run(JointStatePublisherGui)
    assert wait_until(lambda: sliders.has_parameter("joints.to_finger"), 10)
    sliders.set_parameters(
        [zbot.Parameter(f"joints.to_{name}", value=value) for name, value in POSITIONS.items()]
    )
    frames, model = Frames(), RobotModel("/robot_description")
    frames.diagnosis = TransformMonitor(bench.watcher, frames).diagnosis
    frames.choose("base")
    model.take(String(data=text))

    def difference() -> float:
        model.tick(0)
        tree = frames.refresh()
        if len(model.items) < 6 or len(tree.poses) < 6:
            return np.inf
        links = ("base", *JOINTS)
        gaps = [np.abs(shown(frames, model, link) - corners(link)).max() for link in links]
        return float(max(gaps))

    assert wait_until(lambda: difference() < 1e-5, 20), difference()
