"""Tests of worlds: those of zbot, maps, and files in MJCF."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
import pytest

from zbot.libraries.navigation.map_image import GreyImage, write_image
from zbot.simulation.errors import SimulationError
from zbot.simulation.places import free_places
from zbot.simulation.world import World
from zbot.simulation.worlds.catalog import WORLDS, maze
from zbot.simulation.worlds.file import find_world
from zbot.simulation.worlds.map import rectangles
from zbot.simulation.worlds.plan import Place, Plan

if TYPE_CHECKING:
    from pathlib import Path


@pytest.mark.parametrize("name", WORLDS)
def test_each_world_has_room_for_ten_robots(name: str) -> None:
    found = find_world(name)
    places = free_places(World(found.spec), found.start, 10)
    assert places[0] == found.start
    assert all(math.hypot(a.x - b.x, a.y - b.y) > 0.5 for a in places for b in places if a is not b)


def test_the_exit_of_the_maze_can_be_reached() -> None:
    plan = maze()
    world = World(plan.spec())
    low, high = world.bounds()
    places = free_places(world, plan.start, 60)  # the maze has 36 cells
    assert (low < (plan.start.x, plan.start.y)).all()
    assert any(place.x > high[0] for place in places)


def test_a_robot_that_would_start_in_a_wall_starts_beside_it() -> None:
    plan = Plan()
    plan.room(-2, -2, 2, 2)
    plan.box(0.0, 0.0, (1.0, 1.0, 0.5))
    (place,) = free_places(World(plan.spec()), Place(), 1)
    assert 0.7 < math.hypot(place.x, place.y) < 1.2


def test_a_world_without_room_says_for_how_many_robots_there_is_room() -> None:
    plan = Plan()
    plan.room(-0.6, -0.6, 0.6, 0.6)
    with pytest.raises(SimulationError, match="free places for only 1 robots"):
        free_places(World(plan.spec()), Place(), 5)


def test_rectangles_cover_all_occupied_cells_once() -> None:
    random = np.random.default_rng(1)
    for _ in range(20):
        cells = random.random((12, 17)) < 0.4
        covered = np.zeros_like(cells, int)
        for top, left, bottom, right in rectangles(cells):
            covered[top:bottom, left:right] += 1
        assert (covered == cells).all()


def map_file(folder: Path, rows: list[str], yaml: str = "") -> Path:
    """Write a map whose walls are `#`."""
    pixels = bytes(0 if sign == "#" else 254 for row in rows for sign in row)
    write_image(folder / "map.pgm", GreyImage(len(rows[0]), len(rows), pixels))
    path = folder / "map.yaml"
    text = (
        "image: map.pgm\nresolution: 0.5\norigin: [-2.0, -1.0, 0.0]\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.25\n"
    )
    path.write_text(yaml or text)
    return path


def test_a_map_becomes_walls_at_its_origin(tmp_path: Path) -> None:
    rows = ["########", "#......#", "#......#", "#......#", "########"]
    world = World(find_world(str(map_file(tmp_path, rows))).spec)
    low, high = world.bounds()
    assert low == pytest.approx([-2.0, -1.0])
    assert high == pytest.approx([2.0, 1.5])
    rays = np.array([[1.0, 0, 0], [0, 1.0, 0], [-1.0, 0, 0], [0, -1.0, 0]])
    distances, _, _ = world.cast(np.array([0.0, 0.0, 0.2]), rays)
    assert distances == pytest.approx([1.5, 1.0, 1.5, 0.5])


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("rooom", None, "there is no world 'rooom'; did you mean 'room'"),
        ("a.yaml", None, "there is no file"),
        ("a.txt", None, "there is no world"),
        ("a.yaml", "image: b.pgm\n", "origin must be a list"),
        ("a.xml", "<robot/>", "is not a world in MJCF"),
        ("a.xml", "<mujoco><include file='a.xml'/></mujoco>", "the tag <include> is not supported"),
        ("a.xml", "<mujoco><worldbody><geom size='nan'/></worldbody></mujoco>", "nan"),
        ("a.xml", "<!DOCTYPE a [<!ENTITY b 'c'>]><mujoco/>", "must not define entities"),
    ],
)
def test_a_wrong_world_is_told_in_one_sentence(
    tmp_path: Path, name: str, text: str | None, said: str
) -> None:
    if text is not None:
        (tmp_path / name).write_text(text)
    path = str(tmp_path / name) if "." in name else name
    with pytest.raises(SimulationError) as caught:
        World(find_world(path).spec)
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_file_in_mjcf_is_a_world_with_things(tmp_path: Path) -> None:
    path = tmp_path / "a.xml"
    path.write_text(
        "<mujoco><worldbody><geom type='plane' size='5 5 1'/>"
        "<body name='ball' pos='1 0 1'><freejoint/><geom size='0.1'/></body>"
        "</worldbody></mujoco>"
    )
    world = World(find_world(str(path)).spec)
    assert list(world.things) == ["ball"]
