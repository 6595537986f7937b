"""Tests of worlds and robots that ask for too much: each is refused with one sentence."""

from __future__ import annotations

import os
import random
import struct
import sys
import time
from typing import TYPE_CHECKING

import numpy as np
import pytest

from tests.conftest import allowed
from zbot.errors import ZbotError
from zbot.simulation.errors import SimulationError
from zbot.simulation.meshes.file import read_triangles
from zbot.simulation.meshes.hull import check_points
from zbot.simulation.meshes.pieces import _connected
from zbot.simulation.robots.catalog import find_robot
from zbot.simulation.robots.model import read_robot
from zbot.simulation.world import World
from zbot.simulation.worlds.file import find_world
from zbot.simulation.worlds.plan import Plan
from zbot.tf2.rigid import Rigid

if TYPE_CHECKING:
    from pathlib import Path

_HUGE = 10**9
_INERTIA = "<inertial><mass value='{}'/><inertia ixx='{}' iyy='1' izz='1'/></inertial>"
_BOX = "<collision>{}<geometry><box size='1 1 1'/></geometry></collision>"


def link(name: str = "a", mass: str = "1", moment: str = "1", origin: str = "") -> str:
    """Return a link of a robot."""
    return f"<link name='{name}'>{_INERTIA.format(mass, moment)}{_BOX.format(origin)}</link>"


def chain(count: int, kind: str) -> str:
    """Return links in a row, with the joints between them."""
    joints = (
        f"<joint name='j{number}' type='{kind}'><parent link='l{number}'/>"
        f"<child link='l{number + 1}'/></joint>"
        for number in range(count - 1)
    )
    return "".join((*(link(f"l{number}") for number in range(count)), *joints))


def refusal_of_robot(content: str) -> str:
    """Return why a robot is refused."""
    with pytest.raises(ZbotError) as caught:
        World(Plan().spec()).add([("r", read_robot(f"<robot name='r'>{content}</robot>"), Rigid())])
    return one_sentence(caught.value)


def refusal_of_world(path: Path) -> str:
    """Return why a world is refused."""
    with pytest.raises(SimulationError) as caught:
        World(find_world(str(path)).spec)
    return one_sentence(caught.value)


def one_sentence(error: BaseException) -> str:
    """Return the text of an error, which must be a line of usual length."""
    text = str(error)
    assert "\n" not in text
    assert len(text) < 400
    return text


def sparse(path: Path, head: bytes = b"") -> Path:
    """Return a file of 1 GB that takes no space on the disk."""
    with path.open("wb") as file:
        file.write(head)
        file.truncate(_HUGE)
    return path


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (chain(10_000, "fixed"), "has 10000 links: the limit is 1000"),
        (chain(200, "continuous"), "has 199 joints that move: the limit is 100"),
        (link(mass="nan"), "must be a number, not 'nan'"),
        (link(mass="1e308"), "1e+308 kg"),
        (link(moment="0"), "moments of inertia are 0 to"),
        (link(moment="1e308"), "at most 1e+06"),
        (link(origin="<origin xyz='1e308 0 0'/>"), "more than 10 km away"),
        (f"<link name='a'>{_BOX.format('') * 2001}</link>", "2001 <collision> tags"),
    ],
)
def test_a_robot_that_asks_for_too_much_is_refused(content: str, said: str) -> None:
    assert said in refusal_of_robot(content)


def test_entities_of_xml_are_refused_in_robots_and_worlds(tmp_path: Path) -> None:
    bomb = "<!DOCTYPE a [<!ENTITY a 'aa'><!ENTITY b '&a;&a;&a;&a;&a;&a;'>]>"
    for name, text in (("a.sdf", "<sdf>&b;</sdf>"), ("a.xml", "<mujoco>&b;</mujoco>")):
        (tmp_path / name).write_text(bomb + text)
        assert "must not define entities" in refusal_of_world(tmp_path / name)
    with pytest.raises(ZbotError, match="must not define entities"):
        read_robot(f"{bomb}<robot name='&b;'/>")


@pytest.mark.parametrize("name", ["a.sdf", "a.world", "a.xml", "a.yaml"])
def test_a_world_of_a_gigabyte_is_refused(tmp_path: Path, name: str) -> None:
    assert "more than" in refusal_of_world(sparse(tmp_path / name, b"<sdf>"))


@pytest.mark.parametrize("ending", ["stl", "obj", "dae"])
def test_a_mesh_of_a_gigabyte_is_refused(tmp_path: Path, ending: str) -> None:
    mesh = sparse(tmp_path / f"a.{ending}", bytes(80) + struct.pack("<I", (_HUGE - 84) // 50))
    world = tmp_path / "a.sdf"
    world.write_text(
        "<sdf version='1.9'><model name='m'><static>1</static><link name='l'><collision name='c'>"
        f"<geometry><mesh><uri>{mesh}</uri></mesh></geometry></collision></link></model></sdf>"
    )
    assert "more than 50 MB" in refusal_of_world(world)
    shape = f"<collision><geometry><mesh filename='file://{mesh}'/></geometry></collision>"
    assert "more than 50 MB" in refusal_of_robot(f"<link name='a'>{shape}</link>")


def collada(x: str, number: str) -> str:
    """Return a triangle with a coordinate of its last point, and with the number of this point."""
    source = f"<source id='p'><float_array>0 0 0 1 0 0 {x} 1 0</float_array></source>"
    points = "<vertices><input semantic='POSITION' source='#p'/></vertices>"
    faces = f"<triangles><input semantic='VERTEX' offset='0'/><p>0 1 {number}</p></triangles>"
    mesh = f"<geometry id='g'><mesh>{source}{points}{faces}</mesh></geometry>"
    return f"<COLLADA><library_geometries>{mesh}</library_geometries></COLLADA>"


def test_too_large_numbers_of_a_mesh_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.dae"
    path.write_text(collada("0", "9" * 30))
    with pytest.raises(SimulationError, match="a number of a point is too large"):
        read_triangles(path)
    path.write_text(collada("1e300", "2"))
    with pytest.raises(SimulationError, match="has points that are not within 10 km"):
        check_points(read_triangles(path), path)  # numpy prints no warning


@pytest.mark.parametrize(
    ("nodes", "said"),
    [
        ("<node>" + "<instance_geometry url='#g'/>" * 60_000 + "</node>", "too many triangles"),
        (
            "<node id='a'>" + "<scale>1 1 1</scale>" * 2000 + "</node>"
            "<node>" + "<instance_node url='#a'/>" * 5000 + "</node>",
            "too many nodes",
        ),
    ],
)
def test_a_scene_that_places_its_parts_too_often_is_refused(
    tmp_path: Path, nodes: str, said: str
) -> None:
    scene = f"<library_visual_scenes><visual_scene>{nodes}</visual_scene></library_visual_scenes>"
    path = tmp_path / "a.dae"
    path.write_text(collada("0", "2" + " 0 1 2" * 100).replace("</COLLADA>", f"{scene}</COLLADA>"))
    begin = time.process_time()
    with pytest.raises(SimulationError, match=said):
        read_triangles(path)
    assert time.process_time() - begin < allowed(3)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no devices in folders")
def test_devices_and_pipes_are_refused(tmp_path: Path) -> None:
    (tmp_path / "a.stl").symlink_to("/dev/zero")
    os.mkfifo(tmp_path / "b.stl")
    (tmp_path / "a.urdf").symlink_to("/dev/zero")
    for name in ("a", "b"):
        shape = f"<mesh filename='file://{tmp_path}/{name}.stl'/>"
        content = f"<link name='a'><collision><geometry>{shape}</geometry></collision></link>"
        assert "is a device or a pipe" in refusal_of_robot(content)
    with pytest.raises(ZbotError, match="is a device or a pipe"):
        find_robot(str(tmp_path / "a.urdf"))


def test_a_chain_of_ten_thousand_links_in_sdf_is_refused_at_once(tmp_path: Path) -> None:
    links = "".join(f"<link name='l{number}'/>" for number in range(10_000))
    joints = "".join(
        f"<joint name='j{number}' type='revolute'><parent>l{number}</parent>"
        f"<child>l{number + 1}</child></joint>"
        for number in range(9999)
    )
    path = tmp_path / "a.sdf"
    path.write_text(f"<sdf version='1.9'><model name='m'>{links}{joints}</model></sdf>")
    assert "has 10000 links: the limit is 2000" in refusal_of_world(path)


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ("<asset><hfield name='h' nrow='100000' ncol='100000' size='1 1 1 1'/></asset>", "4096"),
        (
            "<asset>"
            + "".join(
                f"<texture name='t{number}' type='2d' builtin='flat' width='4000' height='4000'/>"
                for number in range(2)
            )
            + "</asset>",
            "more than 16000000 pixels",
        ),
        ("<size nuserdata='2000000000'/>", "is above 10000"),
        ("<size nkey='2000000000'/>", "is above 1000"),
        ("<custom><numeric name='n' size='2000000000'/></custom>", "is above 10000"),
        ("<sensor><user dim='2000000000'/></sensor>", "is above 1000"),
        ("<size nuser_geom='10000'/>", "is above 100"),
        ("<asset><mesh name='m' builtin='plate' params='4000 4000'/></asset>", "is above 100"),
        (
            "<asset>" + "<mesh builtin='sphere' params='4'/>" * 51 + "</asset>",
            "more than 50 meshes",
        ),
        ("<keyframe>" + "<key/>" * 1001 + "</keyframe>", "1001 <key> tags"),
        (
            "".join(f"<compiler meshdir='{number}'/>" for number in range(2000))
            + "<asset>"
            + "<mesh file='a'/>" * 2000
            + "</asset>",
            "more than 20 folders",
        ),
        ("<worldbody>" + "<body/>" * 2001 + "</worldbody>", "2001 <body> tags"),
        ("<asset><model name='m' file='a.xml'/></asset>", "the tag <model> is not supported"),
    ],
)
def test_a_short_mjcf_that_asks_for_much_memory_is_refused(
    tmp_path: Path, content: str, said: str
) -> None:
    path = tmp_path / "a.xml"
    path.write_text(f"<mujoco>{content}</mujoco>")
    assert said in refusal_of_world(path)


def test_files_of_mjcf_have_the_limits_of_other_files(tmp_path: Path) -> None:
    path = tmp_path / "a.xml"
    path.write_text(
        "<mujoco><compiler meshdir='meshes'/><asset><mesh name='m' file='a.stl'/></asset></mujoco>"
    )
    (tmp_path / "meshes").mkdir()
    sparse(tmp_path / "meshes" / "a.stl")
    assert "more than 50 MB" in refusal_of_world(path)
    head = b"\x89PNG\r\n\x1a\n" + struct.pack(">I4sII", 13, b"IHDR", 30_000, 30_000)
    (tmp_path / "meshes" / "a.stl").write_bytes(head)
    assert "more than 16000000 pixels" in refusal_of_world(path)


def test_gravity_and_poses_without_limit_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.sdf"
    for content, said in (
        ("<gravity>0 0 -1e308</gravity>", "<gravity> is above 1000"),
        (
            (
                "<model name='m'><static>1</static><pose>1e308 0 0 0 0 0</pose><link name='l'>"
                "<collision name='c'><geometry><box><size>1 1 1</size></box></geometry></collision>"
                "</link></model>"
            ),
            "more than 10 km away",
        ),
    ):
        path.write_text(f"<sdf version='1.9'><world name='w'>{content}</world></sdf>")
        assert said in refusal_of_world(path)


def test_values_that_grow_without_limit_are_noticed() -> None:
    world = World(Plan().spec())
    shape = "<link name='a'>" + _INERTIA.format("1", "1") + _BOX.format("") + "</link>"
    (robot,) = world.add([("r", read_robot(f"<robot name='r'>{shape}</robot>"), Rigid())])
    world.step()
    assert not world.broke_down
    world.data.qvel[:] = 1e200
    for _ in range(3):
        world.step()
    assert world.broke_down
    assert abs(robot.pose.translation[0]) < 1e6


def world_of(path: Path, content: str) -> Path:
    """Return a file with a world in SDF."""
    path.write_text(f"<sdf version='1.9'><world name='w'>{content}</world></sdf>")
    return path


@pytest.mark.parametrize(
    "content",
    [
        "<include/>" * 20_000,
        "".join(f"<include><uri>model://a{number}</uri></include>" for number in range(1000)),
        "".join(f"<tag{number}/>" for number in range(20_000)),
        "<model name='a'><link name='l'/></model>" * 2000,
        "<model name='m'><link name='l'/><plugin filename='gazebo_ros JointController'>"
        + "<joint_name>a</joint_name>" * 20_000
        + "</plugin></model>",
        "<model name='m'>"
        + "".join(f"<link name='a{number}'/>" for number in range(1900))
        + "".join(
            f"<joint name='j{number}' type='t{number}'><parent>x</parent><child>y</child></joint>"
            for number in range(10_000)
        )
        + "</model>",
    ],
)
def test_a_world_with_many_equal_or_missing_parts_is_read_quickly(
    tmp_path: Path, content: str
) -> None:
    path = world_of(tmp_path / "a.sdf", content)
    begin = time.process_time()
    assert find_world(str(path)).notices is not None
    assert time.process_time() - begin < allowed(4)


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ("".join(f"<link name='{number}'/>" for number in range(2001)), "has 2001 links"),
        (f"<link name='{'a' * 501}'/>", "a name has more than 500 characters"),
    ],
)
def test_a_model_that_is_too_large_is_refused(tmp_path: Path, content: str, said: str) -> None:
    path = world_of(tmp_path / "a.sdf", f"<model name='m'>{content}</model>")
    assert said in refusal_of_world(path)


def test_the_notices_of_a_world_have_a_limit(tmp_path: Path) -> None:
    path = world_of(tmp_path / "a.sdf", "".join(f"<tag{number}/>" for number in range(1000)))
    assert len(find_world(str(path)).notices) == 300


def test_a_long_strip_of_triangles_in_any_order_is_one_part() -> None:
    order = random.Random(1).sample(range(20_000), 20_000)
    points = np.array([(place, 0.0, 0.0) for place in order])
    sides = points[:-1] + np.array([0.0, 1.0, 0.0])
    triangles = np.stack([points[:-1], points[1:], sides], axis=1)
    begin = time.process_time()
    (part,) = _connected(triangles)
    assert len(part) == len(triangles)
    far = triangles + np.array([0.0, 0.0, 9.0])
    assert [len(part) for part in _connected(np.concatenate([triangles, far]))] == [19_999] * 2
    assert time.process_time() - begin < allowed(2)
