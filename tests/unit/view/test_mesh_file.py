"""Files of surfaces are found by their address and read in metres."""

from __future__ import annotations

import os
import sys
import threading
from typing import TYPE_CHECKING

import numpy as np
import pytest

from tests.conftest import wait_until
from zbot.libraries.robot_description.mesh_address import path_of
from zbot.view import mesh_file
from zbot.view.errors import DisplayError
from zbot.view.mesh_file import MeshFiles, read_mesh_file
from zbot.view.shape import Mesh

if TYPE_CHECKING:
    from pathlib import Path

_COLLADA = """<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
 <asset><unit name="millimeter" meter="0.001"/><up_axis>Z_UP</up_axis></asset>
 <library_geometries><geometry id="g"><mesh>
  <source id="p"><float_array id="pa" count="9">0 0 0 1000 0 0 0 2000 0</float_array>
   <technique_common><accessor source="#pa" count="3" stride="3">
    <param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
   </accessor></technique_common></source>
  <source id="n"><float_array id="na" count="3">0 0 1</float_array>
   <technique_common><accessor source="#na" count="1" stride="3">
    <param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
   </accessor></technique_common></source>
  <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
  <triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/>
   <input semantic="NORMAL" source="#n" offset="1"/><p>0 0 1 0 2 0</p></triangles>
 </mesh></geometry></library_geometries>
 <library_visual_scenes><visual_scene id="s"><node>
  <instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
 <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>"""
_OBJECT = "v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n"
_STL = """solid a
facet normal 0 0 1\nouter loop
vertex 0 0 0\nvertex 1 0 0\nvertex 0 2 0
endloop\nendfacet\nendsolid a\n"""


@pytest.mark.filterwarnings("ignore:Setting the shape:DeprecationWarning")  # of pycollada
@pytest.mark.parametrize(
    ("name", "text"), [("a.dae", _COLLADA), ("a.obj", _OBJECT), ("a.STL", _STL)]
)
def test_files_are_read_in_metres(tmp_path: Path, name: str, text: str) -> None:
    pytest.importorskip("trimesh", reason='the view needs trimesh: pip install "zbot[view]"')
    (tmp_path / name).write_text(text)
    (mesh,) = read_mesh_file((tmp_path / name).as_uri())
    assert mesh.vertices.max(axis=0) == pytest.approx([1, 2, 0])
    assert len(mesh.faces) == 1


@pytest.mark.parametrize(
    ("address", "reason"),
    [
        ("https://example.com/a.stl", "write package://PACKAGE/PATH or file:///PATH"),
        ("package://[/a.stl", "is not an address"),
        ("file://other/share/a.stl", "is on another machine"),
        ("\\\\other\\share\\a.stl", "write package://"),
        ("//other/share/a.stl", "write package://"),
        ("package://no_such_package/a.stl", "is not found"),
        ("file:///etc/passwd", "is not one of .dae, .glb, .obj, .ply, .stl"),
        ("/no/such/file.stl", "there is no file /no/such/file.stl"),
        ("/a\0b.stl", "there is no file"),
        ("", "is not one of"),
    ],
)
def test_other_addresses_are_refused(address: str, reason: str) -> None:
    with pytest.raises(DisplayError, match=reason):
        read_mesh_file(address)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no named pipes in folders")
def test_a_pipe_is_refused(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "a.stl")
    with pytest.raises(DisplayError, match="is no file"):
        read_mesh_file(str(tmp_path / "a.stl"))


def test_a_file_of_a_package_is_found() -> None:
    assert path_of("package://zbot_nodes/meshes/a%20b.stl").parts[-2:] == ("meshes", "a b.stl")


def test_a_damaged_file_has_a_sentence_and_is_read_once(tmp_path: Path) -> None:
    pytest.importorskip("trimesh", reason='the view needs trimesh: pip install "zbot[view]"')
    (tmp_path / "a.dae").write_text("<COLLADA>")
    files, address = MeshFiles(), str(tmp_path / "a.dae")

    def is_read() -> bool:
        try:
            return files.get(address) is not None
        except DisplayError:
            return True

    assert wait_until(is_read)
    with pytest.raises(DisplayError, match="cannot be read"):
        files.get(address)


def triangles(count: int) -> tuple[Mesh, ...]:
    return (Mesh(np.zeros((3, 3), np.float32), np.zeros((count, 3), np.uint32)),)


def test_many_files_are_read_in_one_thread(monkeypatch: pytest.MonkeyPatch) -> None:
    may_read = threading.Event()

    def read(_address: str) -> tuple[Mesh, ...]:
        may_read.wait(10.0)
        return triangles(1)

    monkeypatch.setattr(mesh_file, "read_mesh_file", read)
    files, addresses = MeshFiles(), {f"/mesh_{number}.stl" for number in range(150)}
    before = set(threading.enumerate())
    assert all(files.get(address) is None for address in addresses)
    (reader,) = set(threading.enumerate()) - before
    assert reader.name == "zbot view mesh"
    may_read.set()

    def are_read() -> bool:  # as the displays do, it asks again for those that are not read
        addresses.difference_update({one for one in addresses if files.get(one) is not None})
        return not addresses

    assert wait_until(are_read)


@pytest.mark.parametrize(("limit", "most"), [("_MOST_KEPT", 2), ("_MOST_KEPT_BYTES", 300)])
def test_the_files_that_were_not_used_longest_are_forgotten(
    monkeypatch: pytest.MonkeyPatch, limit: str, most: int
) -> None:
    read: list[str] = []

    def note(address: str) -> tuple[Mesh, ...]:
        read.append(address)
        return triangles(8)  # 132 bytes with the corners

    monkeypatch.setattr(mesh_file, "read_mesh_file", note)
    monkeypatch.setattr(mesh_file, limit, most)
    files = MeshFiles()
    for address in ("a", "b", "a", "c", "a", "b"):
        assert wait_until(lambda one=address: files.get(one) is not None)  # type: ignore[misc]
    assert read == ["a", "b", "c", "b"]


def test_a_defect_of_a_reader_is_a_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(_address: str) -> tuple[Mesh, ...]:
        raise KeyError("defect")

    monkeypatch.setattr(mesh_file, "read_mesh_file", fail)
    files, errors = MeshFiles(), []

    def has_failed() -> bool:
        try:
            files.get("a.stl")
        except DisplayError as error:
            errors.append(str(error))
        return bool(errors)

    assert wait_until(has_failed)
    assert errors == ["a.stl cannot be read: 'defect'"]
