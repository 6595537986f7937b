"""Tests of the bags in the folder of the live page."""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest

from zbot.bag import Writer
from zbot.bag.errors import BagError, BagValueError
from zbot.web.panels.bags import bag_control
from zbot.web.panels.bags.bag_control import BagControl
from zbot.web.panels.bags.panel import date_text

from std_msgs.msg import String

if TYPE_CHECKING:
    from pathlib import Path


def control(folder: Path) -> BagControl:
    system: Any = SimpleNamespace(read_only=False, domain_id=0)
    return BagControl(system, folder)


def write(path: Path) -> None:
    with Writer(path) as writer:
        writer.write("/words", String(data="one"), 1)


@pytest.mark.parametrize("name", ["lesson", "lesson 1", "Übung"])
def test_a_bag_that_is_listed_is_found(tmp_path: Path, name: str) -> None:
    write(tmp_path / name)
    bags = control(tmp_path)
    assert list(bags.bags()) == [name]
    assert bags.path(name) == tmp_path / name


@pytest.mark.parametrize("name", ["", ".", "..", "../other", "inner/", "inner/..", "\0", "lost"])
def test_a_path_to_elsewhere_is_no_bag(tmp_path: Path, name: str) -> None:
    write(tmp_path / "other")
    (tmp_path / "other" / "inner").mkdir()
    with pytest.raises(BagValueError, match="there is no bag"):
        control(tmp_path / "other").path(name)


def test_a_bag_that_was_removed_meanwhile_does_not_hide_the_others(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write(tmp_path / "lesson")
    (tmp_path / "gone.mcap").touch()

    def is_bag(path: Path) -> bool:
        if path.name == "gone.mcap":
            path.unlink()  # as if another program did it in this moment
        return True

    monkeypatch.setattr(bag_control, "_is_bag", is_bag)
    found = control(tmp_path).bags()
    assert found["lesson"].metadata is not None
    assert (found["gone.mcap"].metadata, found["gone.mcap"].problem != "") == (None, True)


def test_a_folder_that_was_removed_is_named(tmp_path: Path) -> None:
    bags = control(tmp_path / "stick")
    with pytest.raises(BagError, match="stick cannot be read"):
        bags.bags()
    with pytest.raises(BagError, match="cannot be read"):
        bags.path("lesson")
    assert bags.free_bytes() is None


@pytest.mark.parametrize("time_ns", [10**21, -(10**30)])
def test_a_bag_with_an_impossible_date_has_none(time_ns: int) -> None:
    assert date_text(time_ns) == ""
